// A mirror shows the rainbow behind the camera.
#include "stage.inc"
Outdoors()
#ifndef (Without) rainbow { angle 30 width 12 distance 10 direction -z color_map { [0 rgb x] [0.5 rgbt <0, 1, 0, 0.5>] [1 rgbf <0, 0, 1, 0.5>] } } #end
sphere { <-1.4, 1.6, -2>, 1 pigment { rgb 0.1 } finish { diffuse 0.1 reflection 0.9 } }
