// A plain lamp, which throws shadows and highlights from the other side.
#include "stage.inc"
Lit(light_source { <-3, 4, -4> rgb <1, 0.8, 0.6> })
