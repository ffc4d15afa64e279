// A picture about a torus.
#include "stage.inc"
#declare Picture = pigment { image_map { png "colours.png" map_type 5 } translate 0.5*y }
Clad(Picture)
