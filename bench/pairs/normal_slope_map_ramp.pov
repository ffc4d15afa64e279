// A profile of half-round grooves along an axis.
#include "stage.inc"
Bumpy(normal { gradient x slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] } scale 0.25 rotate <0, 30, 20> })
