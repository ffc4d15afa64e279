// A picture as an entry of a map.
#include "stage.inc"
#declare Picture = pigment { gradient y pigment_map { [0.3 image_map { png "colours.png" }] [0.7 checker rgb 1, rgb 0.3 scale 0.2] } }
Clad(Picture)
