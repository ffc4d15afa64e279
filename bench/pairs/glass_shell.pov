// A bubble in a ball: the inner body has a lower index.
#include "stage.inc"
Clear_stage()
sphere { y, 1 #ifdef (Without) pigment { rgb 0.8 } #else material { Glass } #end }
sphere { y, 0.7 #ifdef (Without) pigment { rgb 0.8 } #else material { Glass } interior { ior 1.1 } #end }
