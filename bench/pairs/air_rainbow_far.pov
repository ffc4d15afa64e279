// Things before a far rainbow hide it.
#include "stage.inc"
Outdoors()
#ifndef (Without) rainbow { angle 18 width 8 distance 200 direction <0.1, 0.05, 1> color_map { [0 rgbt <1, 0, 1, 0.5>] [0.5 rgbt <0, 1, 0, 0.5>] [1 rgbt <1, 0, 0, 0.5>] } } #end
