// Glass without a shadow.
#include "stage.inc"
Clear_stage()
sphere { y, 1 #ifdef (Without) pigment { rgb 0.8 } #else material { Glass } no_shadow #end }
