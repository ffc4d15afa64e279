// Soft shadows whose grid is refined where its corners differ.
#include "stage.inc"
Lit(light_source { <3, 6, -4> rgb 1 area_light 4*x, 4*z, 9, 9 adaptive 1 })
