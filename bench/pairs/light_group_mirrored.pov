// What a group's lamps light is seen so in a mirror.
#include "stage.inc"
View() Floor()
light_source { <3, 6, -4> rgb 0.5 }
#declare Things = sphere { <0, 1, 0>, 0.8 pigment { rgb <1, 0.8, 0.7> } finish { phong 0.6 } }
#ifdef (Without) object { Things } #else light_group { light_source { <-3, 4, -4> rgb <1, 0.6, 0.3> } object { Things } } #end
box { <-3, 0, 2>, <3, 3, 2.2> pigment { rgb 0.1 } finish { diffuse 0.2 reflection 0.8 } }
