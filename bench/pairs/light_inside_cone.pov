// A spot that looks past everything, at the horizon.
#include "stage.inc"
Lit(light_source { <-1, 0.6, -3> rgb 1.5 spotlight radius 20 falloff 45 point_at <0.4, 0.6, 0> })
