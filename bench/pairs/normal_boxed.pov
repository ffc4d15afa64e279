// A slope towards the middle of a cube.
#include "stage.inc"
Bumpy(normal { boxed 2 frequency 4 sine_wave scale 4 })
