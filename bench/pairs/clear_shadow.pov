// Shadows have the colours of all that light has passed.
#include "stage.inc"
View() Sun() Floor()
#for (I, 0, 3)
  cylinder { <I - 2, 1 + 0.4*I, -1>, <I - 2, 1.05 + 0.4*I, -1>, 0.8
    #ifdef (Without) pigment { rgb 0.8 } #else pigment { rgbft <0.3 + 0.2*I, 0.9 - 0.2*I, 0.5, 0.7, 0.2> } #end
  }
#end
