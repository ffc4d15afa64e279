// Ripples run from ten places.
#include "stage.inc"
Bumpy(normal { ripples 0.5 frequency 3 scale 0.5 })
