// A cone whose radius is above its falloff: its edge is sharp.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 spotlight radius 16 falloff 10 point_at <0, 0.5, 0> })
