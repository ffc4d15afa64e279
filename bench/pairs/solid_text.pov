// Letters of one of POV-Ray's fonts.
#include "stage.inc"
View() Sun() Floor()
#ifdef (Without) #declare Shape = box { 0, <3, 0.7, 0.5> } #else
#declare Shape = text { ttf "timrom.ttf" "Riga 64" 0.5, 0 }
#end
object { Shape pigment { rgb <1, 0.5, 0.2> } scale 1.4 translate <-2, 0.1, 0> }
