// Each lamp of the grid lights by itself.
#include "stage.inc"
Lit(light_source { <0.9, 3, -2> rgb 1 area_light 4*x, 4*z, 5, 5 area_illumination fade_distance 2 fade_power 2 })
