// A prism that is cut off before its point.
#include "stage.inc"
View() Sun() Floor()
#ifdef (Without) #declare Shape = box { <-1, 0, -1>, 1 } #else
#declare Shape = prism { linear_spline conic_sweep 0.4, 1, 6, <-1.5, -1>, <0, -0.4>, <1.5, -1>, <1, 1.2>, <-1, 1>, <-1.5, -1> scale <1, 1.5, 1> }
#end
object { Shape pigment { rgb <0.4, 0.8, 0.5> } }
