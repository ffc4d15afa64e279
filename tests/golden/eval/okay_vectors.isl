// Vectors of two to five terms and how they are promoted.
#version 3.7;
#macro T(X) #debug concat(vstr(3, X, " ", 0, 6), "\n") #end
T(x*1) T(u*1) T(0*x + t) T(-<1, 2, 3>) T(<1, 2, 3>/2) T(2/<1, 2, 4>) T(<1, 2> + <0, 0, 1>) T(<1, 2, 3>*2 + y) T(<1 2 3>)
T(vcross(x, y)) T(vnormalize(<3, 4, 0>)) T(vrotate(<1, 2, 3>, <10, 20, 30>)) T(vaxis_rotate(<1, 2, 3>, <1, 1, 0>, 50))
T(vrotate(x, 45*z)) T(vrotate(z, 90*y)) T(vrotate(x, 90*z)) T(vrotate(y, 90*x))
#declare V = <1, 2, 3, 4, 5>;
#debug concat(str(V.x, 0, 0), str(V.y, 0, 0), str(V.z, 0, 0), str(V.t, 0, 0), str(V.transmit, 0, 0), str(V.filter, 0, 0), "\n")
#debug concat(str(-V.y, 0, 1), " ", str(vlength(<3, 4, 0>), 0, 1), " ", str(vdot(x, <2, 3, 4>), 0, 1), "\n")
