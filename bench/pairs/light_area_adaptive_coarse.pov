// The corners of the grid alone, where they agree.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 area_light 4*x, 4*z, 17, 17 adaptive 0 })
