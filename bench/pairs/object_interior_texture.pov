// Another texture on the inside.
#include "stage.inc"
View() Sun() Floor()
difference {
  sphere { y, 1.2 }
  box { <-2, 1.3, -2>, <2, 3, 2> }
  sphere { y, 1.1 }
  texture { pigment { rgb <1, 0.3, 0.2> } }
}
cylinder {
  <-2, 0.1, -1>, <-2, 1.6, -1>, 0.7 open
  texture { pigment { rgb <0.3, 0.2, 1> } }
  #ifndef (Without) interior_texture { pigment { checker rgb 1, rgb <0.2, 0.7, 0.2> scale 0.3 } } #end
}
