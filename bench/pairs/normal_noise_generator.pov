// The first of the noise generators.
#include "stage.inc"
Bumpy(normal { granite 0.3 noise_generator 1 scale 0.6 })
