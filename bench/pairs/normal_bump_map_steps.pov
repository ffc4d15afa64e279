// Without interpolation the slopes of a picture's pixels are those of their borders.
#include "stage.inc"
Bumpy(normal { bump_map { png "tiles.png" bump_size 2 } scale 2 })
