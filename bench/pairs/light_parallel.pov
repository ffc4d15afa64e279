// Parallel light, which only reaches what lies before the lamp's plane.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 parallel point_at 0 })
