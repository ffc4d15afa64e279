// Transforms of the lamp move the edges of its grid.
#include "stage.inc"
Lit(light_source { 0 rgb 1 area_light 4*x, 4*z, 5, 5 rotate 40*x scale <1, 1, 2> translate <3, 6, -4> })
