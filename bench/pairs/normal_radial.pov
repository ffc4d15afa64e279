// Twelve ridges about the y axis.
#include "stage.inc"
Bumpy(normal { radial 1 frequency 12 sine_wave })
