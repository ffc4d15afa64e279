// Uneven fog.
#include "stage.inc"
Outdoors()
#ifndef (Without) fog { distance 10 rgb <1, 0.8, 0.6> turbulence 0.5 turb_depth 0.8 } #end
