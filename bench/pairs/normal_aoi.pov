// A pattern by the angle of sight mixes bumps.
#include "stage.inc"
Bumpy(normal { aoi normal_map { [0.2 bumps 0.8 scale 0.1] [0.8 wrinkles 0.8 scale 0.3] } })
