// A group's lamp lights its objects alone, and the other lamps do not.
#include "stage.inc"
View() Floor()
light_source { <3, 6, -4> rgb 0.6 }
#declare Lamp = light_source { <-3, 4, -4> rgb <1, 0.6, 0.3> }
#declare Things = union {
  sphere { y, 1 pigment { rgb <1, 0.8, 0.7> } }
  box { <2, 0, 1>, <3, 3, 2> pigment { rgb <0.3, 1, 0.2> } }
}
#ifdef (Without) object { Lamp } object { Things } #else light_group { light_source { Lamp } object { Things } } #end
sphere { <-2, 0.8, 0>, 0.8 pigment { rgb 0.9 } }
