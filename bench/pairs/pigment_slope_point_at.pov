// Colours by the direction to a place.
#include "stage.inc"
View() Sun()
Bodies(texture {
  #ifdef (Without) pigment { rgb 0.6 } #else
  pigment { slope { point_at <0, 4, -2> } color_map { [0.3 rgb <0.1, 0.1, 0.4>] [0.7 rgb <0.8, 0.2, 0.2>] [1 rgb <1, 1, 0.6>] } } #end
})
