// A grid of lamps, each of which sends parallel light.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 parallel point_at 0 area_light 4*x, 4*z, 5, 5 })
