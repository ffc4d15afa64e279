// A cone with a sharp edge.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 spotlight radius 14 falloff 14 point_at <0, 0.5, 0> })
