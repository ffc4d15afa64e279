// Each lamp of the grid has a cone of its own.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 spotlight radius 12 falloff 25 point_at <0, 0.5, 0> area_light 4*x, 4*z, 4, 4 area_illumination })
