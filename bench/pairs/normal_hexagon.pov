// A list of three normals.
#include "stage.inc"
Bumpy(normal { hexagon normal { bumps 0.5 scale 0.2 }, normal { wrinkles 0.8 scale 0.3 }, normal { dents 0.6 scale 0.1 } scale 0.4 })
