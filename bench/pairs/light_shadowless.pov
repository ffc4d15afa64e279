// A lamp without shadows and highlights.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 shadowless })
