// Bricks and their mortar differ in value, so that the edges of bricks are bent.
#include "stage.inc"
Bumpy(normal { brick 1 brick_size <0.8, 0.3, 0.45> mortar 0.08 accuracy 0.05 })
