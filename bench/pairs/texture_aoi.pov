// Textures by the angle of sight.
#include "stage.inc"
View() Sun()
Bodies(texture {
  #ifdef (Without) pigment { rgb 0.6 } #else
  aoi texture_map { [0.55 pigment { rgb <0.2, 0.2, 0.8> }] [0.8 pigment { rgb <1, 0.9, 0.6> } finish { phong 0.8 }] }
  #end
})
