// The soft shadows of a beam.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 cylinder radius 1.5 falloff 2.5 point_at 0 area_light 3*x, 3*z, 4, 4 })
