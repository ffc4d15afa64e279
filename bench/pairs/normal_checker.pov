// A list of two normals.
#include "stage.inc"
Bumpy(normal { checker normal { bumps 0.5 scale 0.2 } normal { leopard 0.8 scale 0.05 } scale 0.5 })
