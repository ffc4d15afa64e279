// Two lamps of two colours.
#include "stage.inc"
View()
light_source { <3, 6, -4> rgb <1, 0.6, 0.3> }
#ifndef (Without) light_source { <-4, 5, -3> rgb <0.3, 0.5, 1> } #end
Still_life(finish { ambient 0.05 diffuse 0.7 phong 0.5 })
