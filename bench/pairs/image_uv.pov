// A picture in the surfaces' own coordinates.
#include "stage.inc"
View() Sun() Floor()
#declare Label = texture { uv_mapping pigment { #ifdef (Without) rgb 0.7 #else image_map { png "colours.png" } #end } }
sphere { y, 1 texture { Label } }
torus { 0.8, 0.3 texture { Label } rotate 60*x translate <-2.3, 1, 0> }
box { <2, 0, 1>, <3, 3, 2> texture { Label } }
