// Each texture of a map has bumps of its own.
#include "stage.inc"
View() Sun()
Bodies(texture {
  gradient x
  texture_map {
    [0 pigment { rgb x } #ifndef (Without) normal { bumps 0.8 scale 0.1 } #end]
    [1 pigment { rgb y } #ifndef (Without) normal { waves 0.6 frequency 9 } #end]
  }
  scale 0.8 rotate 30*z
})
