// The shadows of a spotlight with an area.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 spotlight radius 12 falloff 25 point_at <0, 0.5, 0> area_light 4*x, 4*z, 5, 5 })
