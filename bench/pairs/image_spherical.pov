// A picture about a sphere.
#include "stage.inc"
#declare Picture = pigment { image_map { png "colours.png" map_type 1 } translate y }
Clad(Picture)
