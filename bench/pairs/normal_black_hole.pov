// Bumps that are pulled to a place.
#include "stage.inc"
Bumpy(normal { gradient y 0.5 sine_wave scale 0.2 warp { black_hole <0, 1.5, -0.5>, 1.5 strength 0.8 falloff 2 } })
