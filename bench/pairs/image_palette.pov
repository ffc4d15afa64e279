// The colours of a palette.
#include "stage.inc"
#declare Picture = pigment { image_map { png "palette.png" interpolate 2 } }
Clad(Picture)
