// Sky, rainbow and fog together.
#include "stage.inc"
Outdoors()
#ifndef (Without)
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [1 rgb <0.1, 0.3, 0.8>] } } }
rainbow { angle 20 width 6 distance 20 direction z color_map { [0 rgbt <1, 0, 1, 0.5>] [1 rgbt <1, 0, 0, 0.5>] } }
fog { fog_type 2 distance 20 rgbt <0.8, 0.8, 0.9, 0.2> fog_alt 2 }
#end
