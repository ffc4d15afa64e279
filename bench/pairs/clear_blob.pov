// The textures of a blob's components blend their transparency.
#include "stage.inc"
Clear_stage()
blob {
  threshold 0.4
  sphere { <-0.8, 1, 0>, 1.5, 1 texture { pigment { rgb <1, 0.5, 0.2> } } }
  sphere { <0.8, 1.1, 0>, 1.5, 1 texture { #ifdef (Without) pigment { rgb 0.8 } #else pigment { rgbf <0.4, 0.8, 1, 0.9> } #end } }
}
