// Fog on the ground.
#include "stage.inc"
Outdoors()
#ifndef (Without) fog { fog_type 2 distance 6 rgb <1, 0.8, 0.6> fog_offset 0.5 fog_alt 0.5 } #end
