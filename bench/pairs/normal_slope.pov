// A pattern by the slope of the surface turns its normals.
#include "stage.inc"
Bumpy(normal { slope { y, 0, 1 } normal_map { [0.3 bumps 0.8 scale 0.1] [0.7 wrinkles 0.8 scale 0.3] } })
