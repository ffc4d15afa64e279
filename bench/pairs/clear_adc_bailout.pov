// What lies behind dark faces is left out.
#include "stage.inc"
global_settings { adc_bailout 0.1 }
#declare Bodies_in_a_row = union { sphere { y, 1 } box { <-2, 0.2, -1.7>, <2, 1.6, -1.4> } }
Clear(Bodies_in_a_row, material { texture { pigment { rgbf <0.5, 0.4, 0.3, 0.9> } } })
