// Scaling does not make these bumps steeper.
#include "stage.inc"
Bumpy(normal { bumps 0.5 no_bump_scale scale 0.3 })
