// A prism without ends.
#include "stage.inc"
View() Sun() Floor()
#ifdef (Without) #declare Shape = box { <-1, 0, -1>, 1 } #else
#declare Shape = prism { linear_spline 0.1, 1.4, 5, <-1, -1>, <1.2, -0.7>, <0.8, 1>, <-0.7, 0.8>, <-1, -1> open }
#end
object { Shape pigment { rgb <1, 0.5, 0.2> } }
