// Layers on the inside.
#include "stage.inc"
View() Sun() Floor()
#declare Layers =
  texture { pigment { rgb <1, 0.8, 0.3> } }
  texture { pigment { radial frequency 8 color_map { [0 rgbt 1] [1 rgbt <1, 0, 0, 0.2>] } } }
cone {
  <0, 0.1, 0>, 0.4, <0, 1.6, 0>, 1.4 open
  texture { pigment { rgb <0.3, 0.2, 1> } }
  #ifndef (Without) interior_texture { Layers } #end
}
