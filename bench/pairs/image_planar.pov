// A picture on the plane of x and y.
#include "stage.inc"
#declare Picture = pigment { image_map { png "colours.png" } }
Clad(Picture)
