// POV-Ray 3.7 finds the same depths, to all digits that it prints, and the same normals but for their sign.
#macro Depth(Object, From, Direction)
  #local Normal = <0, 0, 0>;
  #local Met = trace(Object, From, Direction, Normal);
  #debug concat(str(vlength(Met - From)/vlength(Direction), 0, 9), " ", vstr(3, Normal, " ", 0, 7), "\n")
#end
// 5.266666667 -0.8320503 0.0000000 0.5547002
Depth(prism { linear_spline 0, 1, 4, <0, 0>, <2, 0>, <1, 1.5>, <0, 0> }, <-5, 0.5, 0.4>, x)
// 3.750641131
Depth(prism { quadratic_spline -0.5, 0.5, 6, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>, <1, -1> }, <-5, 0.1, 0.3>, x)
// 3.764745852
Depth(prism { cubic_spline -0.5, 0.5, 7, <-1, 1>, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>, <1, -1> }, <-5, 0.1, 0.3>, x)
// 5.194386031 and 3.863342629
#declare Bezier = prism { bezier_spline 0, 1, 8, <0, 0>, <1, -1>, <2, -1>, <3, 0>, <3, 0>, <2.5, 2>, <0.5, 1>, <0, 0> }
Depth(Bezier, <-5, 0.5, 0.3>, x)
Depth(Bezier, <2, 0.5, 5>, -z)
// 4.000000000 -0.7071068 -0.7071068 0.0000000
Depth(prism { conic_sweep linear_spline 0.5, 2, 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> }, <-5, 1, 0.3>, x)
