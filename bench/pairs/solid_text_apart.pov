// Letters that stand apart and rise.
#include "stage.inc"
View() Sun() Floor()
#ifdef (Without) #declare Shape = box { 0, <3, 0.7, 0.5> } #else
#declare Shape = text { ttf "cyrvetic.ttf" "AVij8" 0.2, <0.1, 0.15, 0> }
#end
object { Shape pigment { rgb <1, 0.5, 0.2> } normal { bumps 0.3 scale 0.1 } scale 1.3 translate <-2, 0.1, 0> }
