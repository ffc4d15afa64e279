// A metal's high index of refraction, and its colour.
#include "stage.inc"
View() Sun() Haze() Floor()
sphere { y, 1
  pigment { rgb <0.8, 0.5, 0.2> }
  finish { diffuse 0.2 specular 0.7 metallic #ifndef (Without) reflection { 0.8 metallic fresnel } #end }
  interior { ior 12 }
}
