// The inside and the outside of an object have normals of their own.
#include "stage.inc"
Bumpy(normal { object { sphere { <0.9, 1.5, 0>, 1.6 } normal { bumps 0.6 scale 0.1 } normal { ripples 0.5 frequency 6 } } })
