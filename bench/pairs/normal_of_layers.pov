// Each layer has bumps of its own.
#include "stage.inc"
#declare Lower = texture { pigment { rgb 0.8 } #ifndef (Without) normal { bumps 0.6 scale 0.3 } #end finish { diffuse 0.8 } }
#declare Upper = texture {
  pigment { rgbt <1, 0.2, 0.2, 0.6> }
  #ifndef (Without) normal { dents 0.9 scale 0.1 } #end
  finish { diffuse 0.8 phong 0.6 }
}
#declare Both = texture { Lower } texture { Upper }
View() Sun()
Bodies(Both)
