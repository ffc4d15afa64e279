// Smooth colours between the pixels' middles.
#include "stage.inc"
#declare Picture = pigment { image_map { png "colours.png" interpolate 3 } scale 2 }
Clad(Picture)
