// The plane is not hollow, so a camera below it sees no fog on its way.
#include "stage.inc"
camera { location <0, -0.5, -5> look_at <0, 1, 0> right 4/3*x }
light_source { <10, 20, -10> rgb 1 }
background { rgb <0.2, 0.2, 0.8> }
plane { y, 0.2 pigment { rgbf <0.9, 0.9, 1, 0.9> } }
sphere { y, 1 pigment { rgb <1, 0.3, 0.2> } }
#ifndef (Without) fog { distance 5 rgb <1, 0.8, 0.6> } #end
