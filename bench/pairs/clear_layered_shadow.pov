// The shadow of three layers.
#include "stage.inc"
View() Sun() Floor()
disc { <0, 1.5, -0.5>, <0.2, 1, -0.3>, 1.2
  texture { pigment { rgbf <1, 0.5, 0.5, 0.9> } }
  #ifndef (Without)
  texture { pigment { checker rgbf <0.3, 0.9, 0.4, 0.9>, rgbt 1 scale 0.4 } }
  texture { pigment { rgbft <0.5, 0.5, 1, 0.5, 0.3> } }
  #end
}
