// A label about a cylinder: nothing above and below it.
#include "stage.inc"
View() Sun() Floor()
cylinder { 0, 2.4*y, 1 pigment { rgb <0.8, 0.8, 0.7> }
  #ifndef (Without) texture { pigment { image_map { png "colours.png" map_type 2 once } scale <1, 1.4, 1> translate 0.5*y } } #end }
