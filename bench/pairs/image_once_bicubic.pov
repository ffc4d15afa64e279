// The border of a single picture with smooth colours.
#include "stage.inc"
Clear_stage()
box { <-1.2, 0.1, -0.2>, <1.2, 2, 0.2> pigment { rgb 0.7 }
  #ifndef (Without) texture { pigment { image_map { png "colours.png" once interpolate 3 } scale 1.5 translate <-0.75, 0.3, 0> } } #end }
