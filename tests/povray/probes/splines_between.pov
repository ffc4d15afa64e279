// Splines between their points and beyond them, of several terms, changed on the way.
#version 3.7;
#macro Say(Name, V) #debug concat(Name, " ", vstr(3, V, " ", 0, 9), "\n") #end
#declare L = spline { linear_spline 0, <0.5, 0.25, 0.75> 1, <1, 2, 3> 2, <4, 0.5, 1> 4, <0.5, 0.25, 0.75> }
#declare Q = spline { quadratic_spline 0, <0.5, 0.25, 0.75> 1, <1, 2, 3> 2, <4, 0.5, 1> 4, <0.5, 0.25, 0.75> }
#declare C = spline { cubic_spline -1, <0.1, 1, 0.2> 0, <0.5, 0.25, 0.75> 1, <1, 2, 3> 2, <4, 0.5, 1> 4, <0.5, 0.25, 0.75> }
#declare N = spline { natural_spline 0, <0.5, 0.25, 0.75> 1, <1, 2, 3> 2, <4, 0.5, 1> 4, <0.5, 0.25, 0.75> }
#for (T, -0.5, 4.5, 0.5)
  Say(concat("linear ", str(T, 0, 1)), L(T))
  Say(concat("quadratic ", str(T, 0, 1)), Q(T))
  Say(concat("cubic ", str(T, 0, 1)), C(T))
  Say(concat("natural ", str(T, 0, 1)), N(T))
#end
Say("as another kind", L(0.5, cubic_spline)) Say("as a natural one", L(1.5, natural_spline))
#declare Unsorted = spline { linear_spline 2, <2, 0, 0> 0, <0.5, 0.25, 0.75> 1, <1, 5, 0> }
Say("in any order", Unsorted(0.5))
#declare Double = spline { linear_spline 0, <0.5, 0.25, 0.75> 1, <1, 1, 1> 1, <2, 2, 2> 2, <3, 3, 3> }
Say("a point given twice", Double(1)) Say("before it", Double(0.5)) Say("after it", Double(1.5))
#declare One = spline { linear_spline 0.5, <1, 2, 3> }
Say("of one point", One(0)) Say("of one point, beyond", One(9))
#declare Five = spline { linear_spline 0, <0, 1, 2, 3, 4> 1, <1, 2, 3, 4, 5> }
#debug concat("of five terms ", vstr(5, Five(0.25), " ", 0, 6), "\n")
#declare Flat = spline { linear_spline 0, <0, 1> 1, <2, 3> }
#debug concat("of two terms ", vstr(2, Flat(0.75), " ", 0, 6), "\n")
Say("an item", <L(0.5).x, L(0.5).y, L(0.5).z>)
