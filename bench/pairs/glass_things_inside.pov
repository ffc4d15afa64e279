// An opaque body within a block.
#include "stage.inc"
Clear_stage()
box { <-1.2, 0, -0.6>, <1.2, 1.8, 0.8> #ifdef (Without) pigment { rgb 0.8 } #else material { Glass } #end rotate 30*y }
sphere { 0.9*y, 0.5 pigment { rgb y } }
