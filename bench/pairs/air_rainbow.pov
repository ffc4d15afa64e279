// A ring of colours about a direction.
#include "stage.inc"
Outdoors()
#ifndef (Without)
rainbow { angle 20 width 10 distance 10 direction z color_map { [0 rgb x] [0.5 rgbt <0, 1, 0, 0.5>] [1 rgbf <0, 0, 1, 0.5>] } }
#end
