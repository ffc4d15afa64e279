// Soft coloured shadows.
#include "stage.inc"
View() Floor()
#ifdef (Without) Sun() #else light_source { <3, 6, -4> rgb 1 area_light 4*x, 4*z, 5, 5 } #end
sphere { y, 1 material { Glass } }
