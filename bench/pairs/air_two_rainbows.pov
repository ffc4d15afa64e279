// Where rainbows overlap their mean is seen.
#include "stage.inc"
Outdoors()
#ifndef (Without)
rainbow { angle 20 width 10 distance 10 direction z color_map { [0 rgb x] [1 rgbf <0, 0, 1, 0.5>] } }
rainbow { angle 22 width 14 distance 20 direction <0.1, 0.1, 1> color_map { [0 rgb x] [1 rgbft <0, 1, 1, 0.5, 0.3>] } }
#end
