// A line of lamps.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 area_light 5*x, 4*z, 9, 1 })
