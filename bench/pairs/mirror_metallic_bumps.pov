// The colour of a metal where bumps turn its normals away from the eye.
#include "stage.inc"
View() Sun() Haze()
Bodies(texture {
  pigment { rgb <1, 0.5, 0.1> }
  #ifndef (Without) normal { agate 1.6 scale 0.5 } #end
  finish { diffuse 0.2 reflection { 0.7 metallic } }
})
