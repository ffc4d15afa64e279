// Facets by the direction of the normal.
#include "stage.inc"
Bumpy(normal { facets size 0.3 })
