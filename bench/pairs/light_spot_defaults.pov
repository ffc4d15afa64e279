// A cone with the angles that it has if none are written.
#include "stage.inc"
Lit(light_source { <1, 3, -2> rgb 1 spotlight point_at <0, 0, 0> })
