// A group's lamp with an area.
#include "stage.inc"
View() Floor()
light_source { <3, 6, -4> rgb 0.4 }
#declare Lamp = light_source { <-3, 4, -4> rgb <1, 0.6, 0.3> #ifndef (Without) area_light 3*x, 3*y, 4, 4 #end }
light_group {
  light_source { Lamp }
  sphere { y, 1 pigment { rgb <1, 0.8, 0.7> } }
  box { <-1.5, 0, -1.5>, <-0.8, 1.2, -0.8> pigment { rgb <0.3, 1, 0.2> } }
  global_lights on
}
