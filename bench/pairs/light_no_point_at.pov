// A beam that goes where beams go of which nothing is said.
#include "stage.inc"
Lit(light_source { <0.3, 1.2, -3.5> rgb 1 cylinder radius 0.6 falloff 1 })
