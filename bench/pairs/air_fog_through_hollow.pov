// Fog within hollow glass, and none within a solid body of glass.
#include "stage.inc"
Outdoors()
#ifndef (Without) fog { distance 5 rgb <1, 0.8, 0.6> } #end
sphere { <-1.2, 1.6, -2>, 0.8 material { Glass } hollow }
sphere { <1, 1.6, -2.5>, 0.8 material { Glass } }
