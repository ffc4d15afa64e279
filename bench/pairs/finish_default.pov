// What a texture has where the scene says nothing.
#include "stage.inc"
#default { texture { pigment { rgb <0.4, 0.6, 0.9> } finish { ambient 0.1 diffuse 0.6 } } }
View() Sun() Floor()
#ifdef (Without) #default { finish { ambient 0 diffuse 0.6 } } #else #default { finish { ambient 0.2 diffuse 0.5 phong 0.8 } } #end
sphere { y, 1 }
