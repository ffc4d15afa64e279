// Corners of the expression rules; printed by POV-Ray 3.7 alike.
#version 3.7;
#macro T(X) #debug concat(str(X, 0, 4), "\n") #end
#declare A = <1, 2, 3>; #declare N = 2; #declare Arr = array[2] {A, <4, 5, 6>}
T(-A.y) T(2*A.x + A.z*N) T(Arr[1].y) T(Arr[N - 2].z) T(-N*-N) T(- -N) T(+N) T(!N) T(!!N) T((N > 1)*3) T((N = 2 & N < 3)) T((0 ? 1/N : N/4))
T(<1, 2>.y) T((A*2).y) T((A + x).x) T(vlength(A - A)) T((N != 2 | N >= 2)) T(1e3) T(.5) T(1.) T(1.5e-2) T((1 - 1 = 0))
#declare B = A*<1, 10, 100> + 1; #debug concat(vstr(3, B, ",", 0, 2), "\n")
#declare B = (N > 1 ? x : y); #debug concat(vstr(3, B, ",", 0, 2), "\n")
#declare Red = color red 1; #declare B = Red*.5 + <0, 1, 0>; #debug concat(vstr(5, B, ",", 0, 2), "\n")
#declare B = A; #declare A = y; #debug concat(vstr(3, B, ",", 0, 0), "\n")
#declare S = concat("a", str(N, 0, 0), chr(66)); #debug concat(strupr(S), "\n")
