// Smooth noise turns the normals.
#include "stage.inc"
Bumpy(normal { bumps 0.5 scale 0.3 })
