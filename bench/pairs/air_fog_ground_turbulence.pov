// Uneven fog on the ground.
#include "stage.inc"
Outdoors()
#ifndef (Without) fog { fog_type 2 distance 8 rgb <0.5, 0.8, 0.6> fog_alt 0.5 turbulence <1, 2, 3> octaves 3 lambda 3 omega 0.7 } #end
