// A picture whose values the scene says how to take.
#include "stage.inc"
#declare Picture = pigment { image_map { png "colours.png" gamma 1 } }
Clad(Picture)
