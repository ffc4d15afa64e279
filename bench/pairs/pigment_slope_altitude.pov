// Colours by slope and height.
#include "stage.inc"
View() Sun()
Bodies(texture {
  #ifdef (Without) pigment { rgb 0.6 } #else
  pigment { slope { y, 0, 0.5 altitude y, 0, 3 } color_map { [0 rgb <0.4, 0.3, 0.2>] [0.5 rgb <0.2, 0.6, 0.2>] [1 rgb 1] } } #end
})
