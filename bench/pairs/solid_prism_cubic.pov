// A prism of curves.
#include "stage.inc"
View() Sun() Floor()
#ifdef (Without) #declare Shape = box { <-1, 0, -1>, 1 } #else
#declare Shape = prism { cubic_spline 0, 1.3, 7, <-1, 0>, <0, -1.2>, <1.4, 0.2>, <0, 0.9>, <-1, 0>, <0, -1.2>, <1.4, 0.2> }
#end
object { Shape pigment { rgb <0.3, 0.8, 0.5> } }
