// From within water the surface is a mirror at grazing angles.
#include "stage.inc"
camera { location <0, 0.4, -4> look_at <0, 1, 0> right 4/3*x }
Sun() Haze() Floor() Stripes()
sphere { <0.6, 0.7, 1>, 0.4 pigment { rgb x } }
plane { y, 1.2 #ifdef (Without) pigment { rgbt 1 } #else pigment { rgbf <0.9, 1, 1, 0.95> } finish { diffuse 0 } interior { ior 1.33 } #end }
