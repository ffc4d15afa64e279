// Edges that are not at right angles, and of different lengths.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 area_light <3, 1, 0>, <0.5, 0, 5>, 6, 3 })
