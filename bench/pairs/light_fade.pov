// Light fades with the distance.
#include "stage.inc"
Lit(light_source { <1, 3, -2> rgb 1 fade_distance 2 fade_power 2 })
