// A slope towards a plane.
#include "stage.inc"
Bumpy(normal { planar 2 frequency 5 sine_wave scale 4 rotate 30*z })
