// trace and inside of prisms: every spline, both sweeps, contours within contours. Normals are compared without their sign.
#version 3.7;
#macro Hit(Name, Prism, P, D)
  #local N = <9, 9, 9>;
  #local H = trace(Prism, P, D, N);
  #debug concat(Name, " ", vstr(3, H, " ", 0, 6), "  normal ", vstr(3, <abs(N.x), abs(N.y), abs(N.z)>, " ", 0, 5), "\n")
#end
#macro Insides(Name, Prism)
  #debug Name
  #for (I, 0, 29)
    #debug concat(" ", str(inside(Prism, <-1.55 + 0.31*mod(I, 10), 0.6, -0.47 + 0.61*int(I/10)>), 0, 0))
  #end
  #debug "\n"
#end
#declare Linear = prism { linear_spline 0, 1, 4, <0, 0>, <2, 0>, <1, 1.5>, <0, 0> }
#declare Quadratic = prism { quadratic_spline -0.5, 0.9, 6, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>, <1, -1> }
#declare Cubic = prism { cubic_spline -0.5, 0.9, 7, <-1, 1>, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>, <1, -1> }
#declare Bezier = prism { bezier_spline 0, 1, 8, <0, 0>, <1, -1>, <2, -1>, <3, 0>, <3, 0>, <2.5, 2>, <0.5, 1>, <0, 0> }
#declare Conic = prism { conic_sweep linear_spline 0.5, 2, 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> }
#declare Tip = prism { conic_sweep cubic_spline 0, 1, 7, <-1, 1>, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>, <1, -1> rotate 20*x }
#declare Frame = prism { 1, 0, 10, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>, <-0.5, -0.5>, <0.5, -0.5>, <0.5, 0.5>, <-0.5, 0.5>, <-0.5, -0.5> }
#declare Star = prism { 0, 1, 6, <0, 1.2>, <0.7, -1>, <-1.1, 0.4>, <1.1, 0.4>, <-0.7, -1>, <0, 1.2> }
Hit("linear", Linear, <-5, 0.5, 0.4>, x)
Hit("linear from within", Linear, <1, 0.5, 0.4>, x)
Hit("linear, its cap", Linear, <1.1, 5, 0.3>, -y)
Hit("linear missed", Linear, <-5, 1.5, 0.4>, x)
Hit("quadratic", Quadratic, <-5, 0.1, 0.3>, x)
Hit("quadratic aslant", Quadratic, <-5, 3, -4>, <1, -0.55, 0.9>)
Hit("cubic", Cubic, <-5, 0.1, 0.3>, x)
Hit("cubic aslant", Cubic, <4, 2.1, -4>, <-1, -0.45, 0.9>)
Hit("bezier", Bezier, <-5, 0.5, 0.3>, x)
Hit("bezier from behind", Bezier, <2, 0.5, 5>, -z)
Hit("conic", Conic, <-5, 1, 0.3>, x)
Hit("conic aslant", Conic, <-5, 3, 0.3>, <1, -0.4, 0.05>)
Hit("tip", Tip, <0.2, 0.5, -5>, z)
Hit("frame", Frame, <-5, 0.5, 0>, <1, 0, 0.01>)
Hit("frame from its hole", Frame, <0, 0.5, 0.1>, x)
Hit("star from its middle", Star, <0, 0.5, 0.1>, <1, 0, 0.2>)
Insides("linear", Linear)
Insides("quadratic", Quadratic)
Insides("cubic", Cubic)
Insides("bezier", Bezier)
Insides("conic", Conic)
Insides("tip", Tip)
Insides("frame", Frame)
Insides("star", Star)
