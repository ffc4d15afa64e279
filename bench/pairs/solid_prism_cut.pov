// What a prism is cut from, and what is cut from a prism.
#include "stage.inc"
View() Sun() Floor()
difference {
  box { <-1.6, 0, -1>, <1.6, 1.2, 1> }
  #ifndef (Without) prism { cubic_spline -0.1, 1.3, 7, <-0.8, 0>, <0, -0.7>, <1.1, 0.1>, <0.1, 0.6>, <-0.8, 0>, <0, -0.7>, <1.1, 0.1> } #end
  pigment { rgb <0.8, 0.8, 0.9> }
}
