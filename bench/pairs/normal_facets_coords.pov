// Facets by the place.
#include "stage.inc"
Bumpy(normal { facets coords 0.5 scale 0.4 })
