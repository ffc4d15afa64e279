// A function of the place is a pattern of values.
#include "stage.inc"
Bumpy(normal { function { 0.5 + 0.25*sin(9*x)*cos(7*y) + 0.25*sin(8*z) } 1.5 })
