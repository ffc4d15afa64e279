// A clear coat on an opaque body, and two clear layers on a disc.
#include "stage.inc"
Clear_stage()
#declare Coat = texture { pigment { rgbf <1, 0.2, 0.1, 0.8> } finish { diffuse 0.3 phong 1 } }
sphere { y, 1 texture { pigment { rgb 0.9 } } #ifndef (Without) texture { Coat } #end }
disc { <1.5, 1.5, -1>, z, 0.7 #ifndef (Without) texture { pigment { rgbt <0, 0, 1, 0.5> } } #end texture { pigment { rgbf <1, 1, 0, 0.6> } } }
