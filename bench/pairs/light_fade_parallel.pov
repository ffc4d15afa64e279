// Parallel light fades from its plane on.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 parallel point_at 0 fade_distance 4 fade_power 2 })
