// A profile of heights and slopes instead of the pattern's own.
#include "stage.inc"
Bumpy(normal { wood 1 slope_map { [0 <0, 1>] [0.5 <1, 1>] [0.5 <1, 0>] [0.7 <1, -1>] [1 <0, -1>] } scale 0.3 })
