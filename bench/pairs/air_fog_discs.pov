// Discs that face the camera and that face away keep no fog out.
#include "stage.inc"
Outdoors()
#ifndef (Without) fog { distance 10 rgb <1, 0.8, 0.6> } #end
disc { <-1.8, 1, 0>, <0.3, 0, 1>, 0.7 pigment { rgb <1, 0.9, 0.3> } }
disc { <1.8, 1, 0>, <0.3, 0, -1>, 0.7 pigment { rgb <0.3, 0.9, 1> } }
