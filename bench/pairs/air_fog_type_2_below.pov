// The camera and what it sees lie in the even part of ground fog.
#include "stage.inc"
Outdoors()
#ifndef (Without) fog { fog_type 2 distance 12 rgb <0.9, 0.9, 0.8> fog_offset 3 fog_alt 1 } #end
