// The bumps lie in the surfaces' own coordinates.
#include "stage.inc"
View() Sun() Floor()
#declare Cloth = texture {
  uv_mapping
  pigment { rgb <1, 0.6, 0.3> }
  #ifndef (Without) normal { leopard 6 scale 0.008 } #end
}
sphere { y, 1 texture { Cloth } }
torus { 0.8, 0.3 texture { Cloth } rotate 60*x translate <-2.3, 1, 0> }
