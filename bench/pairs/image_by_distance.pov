// Colours by the distances of four pixels.
#include "stage.inc"
#declare Picture = pigment { image_map { png "colours.png" interpolate 4 } scale 2 }
Clad(Picture)
