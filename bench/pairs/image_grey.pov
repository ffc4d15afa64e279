// A picture of grey values.
#include "stage.inc"
#declare Picture = pigment { image_map { png "tiles.png" interpolate 2 } }
Clad(Picture)
