// Letters of glass.
#include "stage.inc"
#ifdef (Without) #declare Shape = box { 0, <3, 0.8, 0.5> scale 1.2 translate <-1.8, 0.2, 0> } #else
#declare Shape = text { ttf "crystal.ttf" "Ice" 0.5, 0 scale 1.8 translate <-1.4, 0.2, 0> }
#end
Clear(Shape, Glass)
