// Colours by the angle of sight.
#include "stage.inc"
View() Sun()
Bodies(texture {
  #ifdef (Without) pigment { rgb 0.6 } #else
  pigment { aoi color_map { [0 rgb <0.1, 0.1, 0.4>] [0.5 rgb <0.8, 0.2, 0.2>] [1 rgb <1, 1, 0.6>] } } #end
})
