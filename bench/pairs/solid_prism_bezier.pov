// A prism of Bézier curves that narrows to a point.
#include "stage.inc"
View() Sun() Floor()
#ifdef (Without) #declare Shape = box { <-1, 0, -1>, 1 } #else
#declare Shape = prism {
  bezier_spline conic_sweep 0, 1, 8,
  <-1.5, 0>, <-1.5, -1.5>, <1.5, -1.5>, <1.5, 0>, <1.5, 0>, <1, 1.5>, <-1, 0.5>, <-1.5, 0>
  rotate 180*x scale <1, 2, 1> translate 2*y
}
#end
object { Shape pigment { rgb <0.5, 0.5, 1> } }
