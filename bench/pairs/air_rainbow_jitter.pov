// Compared by mean and spectrum: a rainbow whose edges are blurred by chance.
#include "stage.inc"
Outdoors()
#ifndef (Without)
rainbow { angle 20 width 10 distance 10 jitter 0.06 direction z color_map { [0 rgbt <1, 0, 0, 1>] [0.5 rgbt <0, 1, 0, 0.4>] [1 rgbt <0, 0, 1, 1>] } }
#end
