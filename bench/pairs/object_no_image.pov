// The sphere is seen in the mirror and by its shadow only.
#include "stage.inc"
View() Sun() Haze() Floor()
sphere { y, 1 pigment { rgb <1, 0.3, 0.2> } #ifndef (Without) no_image #end }
box { <-3, 0, 2>, <3, 3, 2.2> pigment { rgb 0.1 } finish { diffuse 0.2 reflection 0.8 } }
