// Finishes are mixed by shading each.
#include "stage.inc"
View() Sun() Haze()
Bodies(texture {
  gradient y
  texture_map {
    [0.3 pigment { rgb <1, 0.5, 0.2> } #ifndef (Without) finish { ambient 0.2 diffuse 0.3 phong 1 } #end]
    [0.7 pigment { rgb <0.3, 0.5, 1> } #ifndef (Without) finish { diffuse 0.8 specular 0.6 } #end]
  }
})
