// The brightness of a picture as a pattern of values.
#include "stage.inc"
Bumpy(normal { image_pattern { png "tiles.png" interpolate 2 } 1.5 })
