// The light of the grid's middle fades; its points only throw shadows.
#include "stage.inc"
Lit(light_source { <0.9, 3, -2> rgb 1 area_light 2*x, 2*z, 5, 5 fade_distance 2 fade_power 2 })
