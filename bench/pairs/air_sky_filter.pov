// A layer that filters what lies below, over a background.
#include "stage.inc"
Outdoors()
#ifndef (Without)
sky_sphere { pigment { rgbt <0, 1, 0, 0.5> } pigment { gradient x color_map { [0 rgbft <0, 0.4, 1, 0.25, 0.25>] [1 rgbf <1, 0.9, 0.5, 0.9>] } scale 2 translate -x } }
#end
