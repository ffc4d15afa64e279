// A picture about a cylinder.
#include "stage.inc"
#declare Picture = pigment { image_map { png "colours.png" map_type 2 } scale <1, 3, 1> }
Clad(Picture)
