// A beam.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 cylinder radius 1 falloff 2 tightness 2 point_at 0 })
