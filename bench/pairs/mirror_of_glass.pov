// A mirror shows a clear body and its shadow.
#include "stage.inc"
View() Sun() Haze() Floor()
sphere { <0.3, 1, 0>, 1 #ifdef (Without) pigment { rgb 0.8 } #else material { Glass } #end }
box { <-3, 0, 2>, <3, 3, 2.2> pigment { rgb 0.1 } finish { diffuse 0.2 #ifndef (Without) reflection 0.8 #end } }
