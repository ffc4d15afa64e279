// A body within a body within a body.
#include "stage.inc"
Clear_stage()
box { <-1.2, 0, -0.8>, <1.2, 2, 0.8> #ifdef (Without) pigment { rgb 0.8 } #else material { texture { Tint } interior { ior 1.33 } } #end rotate 20*y }
sphere { y, 0.7 #ifdef (Without) pigment { rgb 0.8 } #else material { Glass } #end }
sphere { y, 0.4 #ifdef (Without) pigment { rgb 0.8 } #else material { texture { Tint } interior { ior 1.1 } } #end }
