// The mean of two bumps, the second with twice the weight.
#include "stage.inc"
Bumpy(normal { average normal_map { [1 bumps 0.6 scale 0.1] [2 ripples 0.5 frequency 8] } })
