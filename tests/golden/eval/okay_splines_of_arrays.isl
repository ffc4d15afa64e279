// A spline begins with another one, wherever that is held; a number there is its first parameter.
#version 3.8;
#declare A = array[2] { spline { 0, <1, 2, 3> 1, <4, 5, 6> }, spline { linear_spline 0, 1 2, 5 } }
#declare S = spline { A[1] }
#debug concat(str(S(1).x, 0, 2), "\n")
#declare S = spline { A[0] 2, <7, 8, 9> }
#debug concat(vstr(3, S(1.5), " ", 0, 2), "\n")
#declare D = dictionary { .Way: A[1], .Start: 0 };
#declare S = spline { D.Way cubic_spline }
#declare T = array[2] { 0, 1 }
#declare S = spline { T[0], 3 T[1], 5 }
#debug concat(str(S(0.5).x, 0, 2), "\n")
#declare S = spline { D.Start, 3 1, 5 }
#debug concat(str(S(0.5).x, 0, 2), "\n")
#declare F = function(u, v) { x*100 + y*10 + z };
#debug concat(str(F(1, 2), 0, 2), "\n")
sphere { 0, 1 pigment { rgb 1 } normal { spiral1 5, } }
