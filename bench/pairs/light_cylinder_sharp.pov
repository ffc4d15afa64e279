// A beam with a sharp edge and even light.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 cylinder radius 1.5 falloff 1.5 tightness 0 point_at 0 })
