// The texture stretches and turns the bumps that it holds.
#include "stage.inc"
View() Sun()
Bodies(texture {
  pigment { rgb 0.7 }
  #ifndef (Without) normal { quilted 0.8 scale <0.2, 0.05, 0.1> } #end
  finish { diffuse 0.8 }
  scale <2, 1, 1.5> rotate <20, 30, 10>
})
