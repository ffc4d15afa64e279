// A sky that is brighter than its pigment, turned about.
#include "stage.inc"
Outdoors()
#ifndef (Without)
sky_sphere { pigment { wood turbulence 0.2 color_map { [0 rgb <0.3, 0.1, 0.4>] [1 rgb <0.8, 0.6, 0.3>] } scale 0.3 } emission 1.3 rotate <30, 40, 0> }
#end
