// Splines of all kinds, within their range and beyond.
#version 3.7;
#macro Say(Name, N, V) #debug concat(Name, " ", vstr(N, V, " ", 0, 10), "\n") #end
#macro Walk(Name, S) #for (I, -1, 6, 0.7) Say(Name, 3, S(I)) #end #end
#declare L = spline { linear_spline 0,<1,2,3> 1,<4,5,7> 3,<0,1,0> 4,<9,8,7> 5.5,<1,0,0> }
Walk("linear", L)
#declare Q = spline { L quadratic_spline }
Walk("quadratic", Q)
#declare C = spline { L cubic_spline }
Walk("cubic", C)
#declare N = spline { L natural_spline }
Walk("natural", N)
Say("by another kind", 3, L(2, cubic_spline))
Say("and back", 3, L(2))
Say("its items", 2, <L(2).y, L(2).z>)
Say("in arithmetic", 3, 2*L(2) + x)
#declare S = spline { cubic_spline 0,<1,2> 3,<4,8> }
Say("two points, cubic", 2, S(1))
#declare S = spline { natural_spline 0,<1,2> 3,<4,8> }
Say("two points, natural", 2, S(1))
#declare S = spline { quadratic_spline 0,<1,2> 3,<4,8> }
Say("two points, quadratic", 2, S(1))
#declare S = spline { 0,<1,2> }
Say("one point", 2, S(1))
#declare S = spline { linear_spline 2,<0,1> 0 <1,2>, 1, <4,5>, }
Say("in any order, with any commas", 2, S(1.5))
#declare S = spline { linear_spline 0,1 1,5 }
Say("of numbers", 3, S(0.5))
#declare S = spline { linear_spline 0,<1,2,3> 1,<4,5,7> 2,<0,0,0> 1,<9,9,9> }
Say("a point again", 3, S(1.5))
#declare S = spline { linear_spline 0,<1,2,3> 1,<4,5,7> 1,<9,9,9> 2,<0,0,0> }
Say("the last point again", 3, S(1.5))
#declare S = spline { linear_spline #for (I, 0, 3) I, <I, I*I, 2> #end }
Say("points of a loop", 3, S(1.5))
#macro Of(T) T(0.25) #end
Say("through a macro", 3, Of(S))
#declare A = array[2] { spline { 0,<1,2> 1,<5,3> }, spline { 0,<1,2> 1,<5,5> } }
Say("in an array", 2, A[1](0.5))
#declare F = function { spline { L } }
Say("as a function", 3, F(0.5))
#declare G = function(a) { F(a).x + 10*F(a).z }
Say("in a function", 2, <G(0.5), 0>)
