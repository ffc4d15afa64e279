// A palette chooses textures.
#include "stage.inc"
View() Sun() Haze()
Bodies(texture {
  #ifdef (Without) pigment { rgb 0.7 } #else
  material_map {
    png "palette.png"
    texture { pigment { rgb <1, 0.4, 0.2> } }
    texture { pigment { rgb 0.1 } finish { diffuse 0.1 reflection 0.7 } }
    texture { pigment { checker rgb 1, rgb 0.2 scale 0.1 } }
    texture { pigment { rgb <0.2, 0.5, 1> } finish { phong 0.8 } }
  }
  #end
})
