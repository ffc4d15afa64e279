// A prism of glass.
#include "stage.inc"
#ifdef (Without) #declare Shape = box { <-1, 0, -1>, 1 } #else
#declare Shape = prism {
  linear_spline -1.5, 1.5, 4, <-0.9, 0>, <0.9, 0>, <0, 1.4>, <-0.9, 0>
  rotate -90*x rotate 70*y translate 0.1*y
}
#end
Clear(Shape, Glass)
