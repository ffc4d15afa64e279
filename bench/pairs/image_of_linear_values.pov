// A file whose values are taken as they are.
#include "stage.inc"
#declare Picture = pigment { image_map { ppm "colours.ppm" interpolate 2 } }
Clad(Picture)
