// Functions of vectors.
#version 3.7;
#macro Say(Name, X) #debug concat(Name, " ", str(X, 0, 9), "\n") #end
#macro Say3(Name, V) #debug concat(Name, " ", vstr(3, V, " ", 0, 9), "\n") #end
Say3("vcross", vcross(<1, 2, 3>, <4, 5, 6>))
Say("vdot", vdot(<1, 2, 3>, <4, 5, 6>))
Say("vlength", vlength(<1, 2, 3>))
Say3("vnormalize", vnormalize(<1, 2, 3>))
Say3("vrotate", vrotate(<1, 2, 3>, <10, 20, 30>))
Say3("vrotate in order", vrotate(<1, 0, 0>, <90, 90, 0>) + 1)
Say3("vrotate by a number", vrotate(<1, 2, 3>, 45))
Say3("vrotate by much", vrotate(<1, 2, 3>, <370, -725, 1000>))
Say3("vaxis_rotate", vaxis_rotate(<1, 2, 3>, <1, 1, 0>, 40))
Say3("vaxis_rotate by a long axis", vaxis_rotate(<1, 2, 3>, <10, 0, 5>, -70))
Say3("vaxis_rotate about itself", vaxis_rotate(<1, 2, 3>, <1, 2, 3>, 33))
Say3("vturbulence", vturbulence(2, 0.5, 6, <1.1, 2.2, 3.3>))
Say3("vturbulence of one octave", vturbulence(3, 0.7, 1, <-1.5, 0.2, 0.3>))
Say3("of numbers", vcross(1, x))
Say3("of two terms", vcross(<1, 2>, z))
Say("vdot of numbers", vdot(2, 3))
Say("vlength of a number", vlength(2))
Say3("componentwise", <1, 2, 3>*<4, 5, 6>/<2, 2, 3>)
Say3("seen from the left", vcross(x, y) + 2*vcross(y, z) + 3*vcross(z, x))
Say("angle", degrees(acos(vdot(vnormalize(<1, 1, 0>), x))))
#declare S = seed(12);
Say3("random ones", <rand(S), rand(S), rand(S)>)
Say3("of a spline", vnormalize(<3, 0, 4>)*vlength(<3, 4, 0>))
