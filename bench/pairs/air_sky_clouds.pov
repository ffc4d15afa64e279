// Clouds over a gradient.
#include "stage.inc"
Outdoors()
#ifndef (Without)
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [1 rgb <0.1, 0.3, 0.8>] } }
  pigment { bozo turbulence 0.6 color_map { [0.4 rgbt 1] [0.8 rgb 1] } scale <0.3, 0.1, 0.3> }
}
#end
