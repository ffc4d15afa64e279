// Fog through which a share of the farthest is still seen.
#include "stage.inc"
Outdoors()
#ifndef (Without) fog { distance 6 rgbt <1, 0.8, 0.6, 0.4> } #end
