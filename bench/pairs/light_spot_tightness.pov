// A cone that is brighter in the middle.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 spotlight radius 12 falloff 25 tightness 10 point_at <0, 0.5, 0> })
