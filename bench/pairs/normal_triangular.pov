// A list of six normals.
#include "stage.inc"
Bumpy(normal { triangular normal { bumps 0.5 scale 0.2 } normal { bumps 0 } normal { wrinkles 0.5 scale 0.2 } normal { dents 0.5 scale 0.1 } normal { bumps 0.9 scale 0.1 } normal { bumps 0 } scale 0.47 })
