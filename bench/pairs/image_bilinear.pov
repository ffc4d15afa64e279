// Colours between the pixels' middles.
#include "stage.inc"
#declare Picture = pigment { image_map { png "colours.png" interpolate 2 } scale 2 }
Clad(Picture)
