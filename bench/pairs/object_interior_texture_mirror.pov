// A mirror on the inside alone.
#include "stage.inc"
View() Sun() Haze() Floor()
sphere { 1.2*y, 1.2
  texture { pigment { rgb <0.8, 0.3, 0.2> } }
  #ifndef (Without) interior_texture { pigment { rgb 0.1 } finish { diffuse 0.1 reflection 0.8 } } #end
  clipped_by { plane { <-0.1, 0.5, -1>, 0.4 } }
}
