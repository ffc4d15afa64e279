// A round grid that turns to each point, refined where it has to be.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 area_light 4*x, 4*z, 17, 17 adaptive 2 circular orient })
