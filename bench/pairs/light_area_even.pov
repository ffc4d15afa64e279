// A grid of four by four lamps.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 area_light 4*x, 4*z, 4, 4 })
