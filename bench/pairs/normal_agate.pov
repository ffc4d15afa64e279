// Agate is a pattern of values.
#include "stage.inc"
Bumpy(normal { agate 0.5 scale 0.7 })
