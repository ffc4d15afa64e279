// The slope is that of the surface as bumps turn it.
#include "stage.inc"
View() Sun()
Bodies(texture {
  #ifdef (Without) pigment { rgb 0.6 } #else pigment { slope y color_map { [0.4 rgb <0.4, 0.3, 0.2>] [0.6 rgb <0.2, 0.6, 0.2>] [0.9 rgb 1] } } #end
  normal { bumps 0.6 scale 0.3 }
})
