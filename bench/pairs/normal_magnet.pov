// The slopes of a fractal of magnetism.
#include "stage.inc"
Bumpy(normal { magnet 1 mandel 20 2 scale 0.7 })
