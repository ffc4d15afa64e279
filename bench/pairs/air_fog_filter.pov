// Fog that colours what is seen through it.
#include "stage.inc"
Outdoors()
#ifndef (Without) fog { distance 10 rgbf <1, 0.7, 0.4, 0.8> } #end
