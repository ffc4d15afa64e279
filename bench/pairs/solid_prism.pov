// A prism with a hole.
#include "stage.inc"
View() Sun() Floor()
#ifdef (Without) #declare Shape = box { <-1, 0, -1>, 1 } #else
#declare Shape = prism {
  linear_spline 0, 1, 9,
  <-1.5, -1>, <1.5, -1>, <1, 1.2>, <-0.5, 0.6>, <-1.5, -1>,
  <-0.4, -0.5>, <0.6, -0.5>, <0.2, 0.3>, <-0.4, -0.5>
}
#end
object { Shape pigment { rgb <1, 0.5, 0.2> } }
