// A cone of light.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 spotlight radius 10 falloff 20 point_at <0, 0.5, 0> })
