// Letters that are cut out of a slab.
#include "stage.inc"
View() Sun() Floor()
difference {
  box { <-2.2, -0.3, 0.2>, <2.5, 1.4, 0.5> }
  #ifndef (Without) text { ttf "cyrvetic.ttf" "Stone" 1, 0.05*x scale 1.5 translate -2*x } #end
  pigment { rgb <0.8, 0.8, 0.9> }
  rotate 15*x translate 0.5*y
}
