// Textures by the slope of the surface.
#include "stage.inc"
View() Sun()
Bodies(texture {
  #ifdef (Without) pigment { rgb 0.6 } #else
  slope { y, 0.2, 0.9 }
  texture_map { [0.4 pigment { rgb <0.4, 0.3, 0.2> } normal { granite 0.4 scale 0.5 }] [0.6 pigment { rgb <0.9, 0.9, 1> } finish { phong 0.6 }] }
  #end
})
