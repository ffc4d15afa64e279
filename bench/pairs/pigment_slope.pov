// Colours by the slope of the surface.
#include "stage.inc"
View() Sun()
Bodies(texture {
  #ifdef (Without) pigment { rgb 0.6 } #else
  pigment { slope y color_map { [0.4 rgb <0.4, 0.3, 0.2>] [0.6 rgb <0.2, 0.6, 0.2>] [0.9 rgb 1] } } #end
})
