// One picture, and nothing around it.
#include "stage.inc"
Clear_stage()
sphere { y, 1 pigment { rgb 0.7 } #ifndef (Without) texture { pigment { image_map { png "colours.png" once interpolate 2 } translate <-0.5, 0.5, 0> } } #end }
