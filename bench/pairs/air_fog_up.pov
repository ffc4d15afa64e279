// Fog on a slanted ground.
#include "stage.inc"
Outdoors()
#ifndef (Without) fog { fog_type 2 distance 10 rgb <1, 0.8, 0.6> fog_alt 0.5 up <0, 3, 0> rotate 40*z } #end
