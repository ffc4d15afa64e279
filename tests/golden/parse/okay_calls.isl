Tree(Depth, <0, 1, 0> 3)
F()
G(A)
G((A))
G(A[1])
Splines[2](0.5)
#Old_Style (1)
#declare R = rand(Seed) + vdot(x, y) + defined(A[1]);
