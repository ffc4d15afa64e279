// A pattern chooses and mixes bumps.
#include "stage.inc"
Bumpy(normal { gradient y normal_map { [0 bumps 0.6 scale 0.1] [0.5 dents 0.5 scale 0.2] [1 agate 0.5] } scale 0.7 })
