// Turbulent marble is a pattern of values.
#include "stage.inc"
Bumpy(normal { marble 0.8 turbulence 0.5 scale 0.4 })
