// A declared texture is scaled where it is used.
#include "stage.inc"
#declare Rough = texture { pigment { rgb <0.7, 0.8, 1> } #ifndef (Without) normal { granite 0.4 scale 0.5 } #end finish { diffuse 0.8 } }
View() Sun()
Bodies(texture { Rough scale <0.5, 2, 0.5> rotate 30*z })
