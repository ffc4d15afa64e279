// A double spiral of five arms.
#include "stage.inc"
Bumpy(normal { spiral2 5 0.8 sine_wave scale 0.4 })
