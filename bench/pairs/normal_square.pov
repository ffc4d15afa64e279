// A list of four normals.
#include "stage.inc"
Bumpy(normal { square normal { bumps 0.5 scale 0.2 } normal { bumps 0 } normal { wrinkles 0.5 scale 0.2 } normal { dents 0.5 scale 0.1 } scale 0.47 })
