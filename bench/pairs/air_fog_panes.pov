// Clear triangles keep the fog out of what is seen through them, whichever way their corners go round.
#include "stage.inc"
Outdoors()
#ifndef (Without) fog { distance 8 rgb <1, 0.8, 0.6> } #end
triangle { <-2.4, 0.2, -1>, <-0.4, 0.2, -1>, <-1.4, 2.4, -1> pigment { rgbt <1, 0.9, 0.3, 0.7> } }
triangle { <0.4, 0.2, -1>, <1.4, 2.4, -1>, <2.4, 0.2, -1> pigment { rgbt <0.3, 0.9, 1, 0.7> } }
