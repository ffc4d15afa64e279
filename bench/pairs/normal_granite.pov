// Granite is a pattern of values, whose slopes turn the normals.
#include "stage.inc"
Bumpy(normal { granite 0.3 scale 0.5 })
