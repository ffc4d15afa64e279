// Each body fades light by its own way through it.
#include "stage.inc"
Clear_stage()
box { <-1.2, 0, -0.8>, <1.2, 2, 0.8>
  #ifdef (Without) pigment { rgb 0.8 } #else
  pigment { rgbt 1 } finish { diffuse 0 } interior { ior 1.33 fade_distance 2 fade_power 1001 fade_color <0.3, 0.6, 0.9> } #end
  rotate 20*y
}
sphere { y, 0.6
  #ifdef (Without) pigment { rgb 0.8 } #else
  pigment { rgbt 1 } finish { diffuse 0 } interior { ior 1.5 fade_distance 0.5 fade_power 2 fade_color <0.9, 0.6, 0.2> } #end
}
