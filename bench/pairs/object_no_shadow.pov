// The sphere and the box throw no shadow.
#include "stage.inc"
View() Sun() Floor()
sphere { y, 1 pigment { rgb <1, 0.3, 0.2> } #ifndef (Without) no_shadow #end }
box { <2, 0, 1>, <3, 3, 2> pigment { rgb <0.3, 1, 0.2> } #ifndef (Without) no_shadow #end }
cylinder { <-2, 0, 0>, <-2, 2, 0>, 0.4 pigment { rgb <0.3, 0.2, 1> } }
