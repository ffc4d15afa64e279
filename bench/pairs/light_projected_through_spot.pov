// A cone through a lattice.
#include "stage.inc"
#declare Lattice = union { #for (I, -3, 3) box { <I/4 - 0.05, 3, -4>, <I/4 + 0.05, 3.05, 0> translate 1.4*x } #end }
Lit(light_source { <3, 6, -4> rgb 1 spotlight radius 15 falloff 25 point_at 0 projected_through { Lattice } })
