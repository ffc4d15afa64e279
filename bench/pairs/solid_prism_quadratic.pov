// A prism of parabolas.
#include "stage.inc"
View() Sun() Floor()
#ifdef (Without) #declare Shape = box { <-1, 0, -1>, 1 } #else
#declare Shape = prism { quadratic_spline 0, 1, 6, <-1, -1>, <-1.2, 0.4>, <0, 1.2>, <1.4, 0.3>, <0.3, -1.1>, <-1.2, 0.4> }
#end
object { Shape pigment { rgb <1, 0.5, 0.2> } }
