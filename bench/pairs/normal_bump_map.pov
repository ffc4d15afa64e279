// Bumps from the brightness of a picture.
#include "stage.inc"
Bumpy(normal { bump_map { png "tiles.png" interpolate 2 bump_size 3 } })
