// Grooves between tiles of two kinds.
#include "stage.inc"
Bumpy(normal { tiling 3 1 scale 0.31 })
