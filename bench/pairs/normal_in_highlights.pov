// Highlights and mirrored light follow the bumps.
#include "stage.inc"
View() Sun() Haze()
Bodies(texture {
  pigment { rgb <1, 0.6, 0.3> }
  #ifndef (Without) normal { bumps 0.3 scale 0.3 } #end
  finish { diffuse 0.5 phong 0.8 phong_size 60 reflection 0.3 }
})
