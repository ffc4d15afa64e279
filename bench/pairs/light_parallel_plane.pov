// The lamp's plane cuts the scene: what lies behind it is dark.
#include "stage.inc"
Lit(light_source { <1.2, 1.4, -0.5> rgb 1 parallel point_at 0 })
