// Splines of the four kinds.
#declare L = spline { linear_spline 0,<1,2,3> 1,<4,5,7>, 3 <0,1,0> 4,<9,8,7> }
#declare Q = spline { L quadratic_spline }
#declare C = spline { L cubic_spline 5.5,<1,0,0> }
#declare N = spline { L natural_spline }
#macro Say(V) #debug concat(vstr(3, V, " ", 0, 9), "\n") #end
#for (I, -0.5, 5, 1) Say(L(I)) Say(Q(I)) Say(C(I)) Say(N(I)) #end
Say(L(2, cubic_spline))
Say(2*L(2) + x)
sphere { L(0.5), L(0.5).x }
