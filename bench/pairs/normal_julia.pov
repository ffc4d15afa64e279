// The slopes of a Julia set.
#include "stage.inc"
Bumpy(normal { julia <0.35, 0.28>, 30 2 scale 1.2 })
