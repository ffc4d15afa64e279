// Cells of one value each are flat but at their borders.
#include "stage.inc"
Bumpy(normal { cells 0.5 accuracy 0.1 scale <0.31, 0.33, 0.35> })
