// The bumps of components blend as their colours do.
#include "stage.inc"
View() Sun() Floor()
blob {
  threshold 0.4
  sphere { <-0.8, 1, 0>, 1.6, 1 texture { pigment { rgb <1, 0.5, 0.2> } #ifndef (Without) normal { bumps 0.8 scale 0.15 } #end } }
  sphere { <0.8, 1.2, 0>, 1.5, 1 texture { pigment { rgb <0.3, 0.6, 1> } #ifndef (Without) normal { ripples 0.6 frequency 6 } #end } }
}
