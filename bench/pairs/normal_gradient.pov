// A sine wave along a slanted axis.
#include "stage.inc"
Bumpy(normal { gradient x 0.5 sine_wave scale 0.3 rotate 40*z })
