// By the index of refraction of an opaque body.
#include "stage.inc"
View() Sun() Haze() Floor()
sphere { y, 1 pigment { rgb <0.3, 0.1, 0.1> } #ifndef (Without) finish { reflection { 0, 1 fresnel } } #end interior { ior 1.5 } }
box { <2, 0, 1>, <3, 3, 2> pigment { rgb 0.1 } #ifndef (Without) finish { reflection { 0.1, 0.9 fresnel } } #end interior { ior 2.5 } }
