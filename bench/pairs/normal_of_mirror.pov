// A mirror with bumps, whose rays do not leave through its back.
#include "stage.inc"
View() Sun() Haze()
Bodies(texture {
  pigment { rgb 0.1 }
  #ifndef (Without) normal { wrinkles 1 scale 0.3 } #end
  finish { diffuse 0.1 reflection 0.9 }
})
