// The slopes of a fractal in the plane of x and y.
#include "stage.inc"
Bumpy(normal { mandel 20 1 scale 1.4 })
