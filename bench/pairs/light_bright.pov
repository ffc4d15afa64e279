// Lamps brighter than white.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb <2.5, 1.8, 1.2> })
