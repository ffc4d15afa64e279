// A clear body whose back faces have a texture of their own.
#include "stage.inc"
Clear_stage()
sphere { y, 1
  texture { pigment { rgbt <1, 1, 1, 0.8> } finish { diffuse 0.3 phong 0.6 } }
  #ifndef (Without) interior_texture { pigment { checker rgbt <1, 0.3, 0.2, 0.3>, rgbt 1 scale 0.4 } } #end
}
