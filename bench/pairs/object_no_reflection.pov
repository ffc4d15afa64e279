// The sphere is not seen in the mirror.
#include "stage.inc"
View() Sun() Haze() Floor()
sphere { y, 1 pigment { rgb <1, 0.3, 0.2> } #ifndef (Without) no_reflection #end }
box { <-3, 0, 2>, <3, 3, 2.2> pigment { rgb 0.1 } finish { diffuse 0.2 reflection 0.8 } }
