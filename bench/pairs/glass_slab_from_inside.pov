// The camera stands in the glass.
#include "stage.inc"
Clear_stage()
sphere { <1, 3, -5>, 2 #ifdef (Without) pigment { rgb 0.8 } hollow #else material { Glass } #end }
sphere { y, 1 pigment { rgb <1, 0.3, 0.2> } }
