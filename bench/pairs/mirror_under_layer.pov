// The lower layer's mirrored light is not filtered by the upper one.
#include "stage.inc"
View() Sun() Haze() Floor()
#declare Lower = texture { pigment { rgb <0.2, 0.2, 0.6> } finish { diffuse 0.5 #ifndef (Without) reflection 0.5 #end } }
#declare Lacquer = texture { pigment { rgbf <1, 0.6, 0.3, 0.7> } finish { diffuse 0.3 phong 0.8 } }
sphere { y, 1 texture { Lower } texture { Lacquer } }
box { <2, 0, 1>, <3, 3, 2> texture { Lower } texture { Lacquer } }
