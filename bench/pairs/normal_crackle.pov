// Cracks, with a finer step for their slopes.
#include "stage.inc"
Bumpy(normal { crackle 1 scale 0.4 accuracy 0.005 })
