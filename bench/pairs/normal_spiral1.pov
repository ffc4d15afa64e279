// A spiral of three arms.
#include "stage.inc"
Bumpy(normal { spiral1 3 0.8 sine_wave scale 0.4 rotate 90*x })
