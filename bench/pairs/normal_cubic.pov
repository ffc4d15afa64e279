// The six sides of a cube have a value each, so that their edges are bent.
#include "stage.inc"
Bumpy(normal { cubic normal { bumps 0.5 scale 0.2 } normal { dents 0.5 scale 0.2 } normal { wrinkles 0.5 scale 0.2 } normal { bumps 0 } normal { ripples 0.5 frequency 6 } normal { leopard 3 scale 0.05 } })
