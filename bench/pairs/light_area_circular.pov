// A round grid of lamps that turns to each point.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 area_light 4*x, 4*z, 9, 9 circular orient })
