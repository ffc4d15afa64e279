// A parallel spotlight has no cone.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 spotlight parallel radius 5 falloff 10 point_at 0 })
