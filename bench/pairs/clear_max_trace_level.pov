// What lies behind too many faces that bend light is black.
#include "stage.inc"
global_settings { max_trace_level 4 }
#declare Bodies_in_a_row = union { sphere { y, 1 } box { <-2, 0.2, -1.7>, <2, 1.6, -1.4> } }
Clear(Bodies_in_a_row, material { texture { pigment { rgbt <0.9, 0.9, 1, 0.8> } } interior { ior 1.1 } })
