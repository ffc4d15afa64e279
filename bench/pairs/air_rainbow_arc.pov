// A part of the ring, which fades towards its ends.
#include "stage.inc"
Outdoors()
#ifndef (Without)
rainbow {
  angle 22 width 8 distance 10 direction <0.1, -0.1, 1> color_map { [0 rgbt <1, 0, 0, 0.3>] [1 rgbf <0, 0, 1, 0.5>] }
  arc_angle 160 falloff_angle 60 up <0.3, 1, 0>
}
#end
