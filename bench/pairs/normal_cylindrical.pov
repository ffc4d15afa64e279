// A slope towards an axis.
#include "stage.inc"
Bumpy(normal { cylindrical 2 frequency 5 sine_wave scale 4 rotate 90*x })
