// The red of a picture without a palette chooses textures.
#include "stage.inc"
View() Sun() Haze()
Bodies(texture {
  #ifdef (Without) pigment { rgb 0.7 } #else
  material_map {
    png "colours.png"
    texture { pigment { rgb <1, 0.4, 0.2> } }
    texture { pigment { rgb <0.2, 0.6, 0.2> } finish { phong 0.8 } }
    texture { pigment { rgb <0.2, 0.5, 1> } }
  }
  #end
})
