// A slope towards the origin within the unit sphere.
#include "stage.inc"
Bumpy(normal { spherical 2 frequency 4 triangle_wave scale 3 })
