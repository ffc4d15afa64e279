// A sky whose colour goes with the height.
#include "stage.inc"
Outdoors()
#ifndef (Without) sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [1 rgb <0.1, 0.3, 0.8>] } } } #end
