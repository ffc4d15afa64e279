// Water with ripples over a chequered ground.
#include "stage.inc"
View() Sun() Haze() Floor()
plane { y, 0.6
  #ifdef (Without) pigment { rgb 0.8 } #else
  pigment { rgbf <0.8, 0.9, 1, 0.9> } normal { ripples 0.1 frequency 4 } finish { diffuse 0 reflection 0.2 } #end
  interior { ior 1.33 }
}
sphere { 0.5*y, 0.6 pigment { rgb x } }
