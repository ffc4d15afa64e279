// Light that shines only through a ring.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 projected_through { torus { 0.5, 0.2 rotate <40, -30, 0> translate <1.8, 4, -2.4> } } })
