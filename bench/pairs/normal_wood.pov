// Rings of wood are a pattern of values.
#include "stage.inc"
Bumpy(normal { wood 0.8 turbulence 0.1 scale 0.3 })
