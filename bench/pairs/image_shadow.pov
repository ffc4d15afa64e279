// The shadow of a foil has the colours of its picture.
#include "stage.inc"
View() Sun() Floor()
box { <-1, 1.5, -1>, <1, 1.52, 1> rotate -15*z
  #ifdef (Without) pigment { rgb 0.8 } #else pigment { image_map { png "colours.png" filter all 0.9 } rotate 90*x scale 2 translate -1 } #end }
