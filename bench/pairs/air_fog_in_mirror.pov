// The way to a mirror and on from it lies in fog.
#include "stage.inc"
Outdoors()
#ifndef (Without) fog { distance 10 rgb <1, 0.8, 0.6> } #end
box { <-3, 0, 3>, <1.5, 3, 3.2> pigment { rgb 0.1 } finish { diffuse 0.1 reflection 0.8 } }
