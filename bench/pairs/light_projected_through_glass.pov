// What lies between the lamp and the object throws no shadow.
#include "stage.inc"
View() Floor()
#ifdef (Without) Sun() #else
light_source { <3, 6, -4> rgb 1 projected_through { disc { <1.5, 3.5, -2>, <1, 2, -1>, 1 } } } #end
sphere { <2.4, 5, -3.2>, 0.3 pigment { rgb x } }
sphere { y, 1 material { Glass } }
