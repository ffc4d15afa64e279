// Sky through a ball of glass.
#include "stage.inc"
Outdoors()
#ifndef (Without) sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.1, 0.3, 0.8>] } } } #end
sphere { <-1.2, 1.8, -2>, 0.9 material { Glass } }
