// Transforms and turbulence move a picture as they move any pattern.
#include "stage.inc"
#declare Picture = pigment { image_map { png "colours.png" interpolate 2 } rotate <20, 30, 10> scale <1, 0.6, 1> warp { turbulence 0.2 } }
Clad(Picture)
