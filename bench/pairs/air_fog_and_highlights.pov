// Fog before highlights and mirrors.
#include "stage.inc"
Outdoors()
#ifndef (Without) fog { distance 12 rgb <0.6, 0.7, 0.8> } #end
sphere { <-1.8, 1, -1>, 0.7 pigment { rgb 0.2 } finish { phong 1 reflection 0.5 } }
