// What the camera does not see is not seen through clear things either, but in mirrors.
#include "stage.inc"
View() Sun() Haze() Floor()
sphere { <0, 1, 0.6>, 0.8 pigment { rgb <1, 0.3, 0.2> } #ifndef (Without) no_image #end }
disc { <0, 1, -1>, z, 0.9 pigment { rgbf <0.7, 0.9, 1, 0.8> } }
box { <-3, 0, 2>, <3, 3, 2.2> pigment { rgb 0.1 } finish { diffuse 0.2 reflection 0.8 } }
