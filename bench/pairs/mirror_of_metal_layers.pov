// Each layer mirrors by itself, and takes from what lies below it with `conserve_energy`.
#include "stage.inc"
View() Sun() Haze() Floor()
#declare Base = texture { pigment { rgb <0.9, 0.6, 0.3> } finish { diffuse 0.6 #ifndef (Without) reflection { 0.3 metallic } #end } }
#declare Film = texture { pigment { rgbt <0.3, 0.5, 1, 0.7> } finish { diffuse 0.4 #ifndef (Without) reflection { 0.1, 0.6 } conserve_energy #end } }
sphere { y, 1 texture { Base } texture { Film } }
box { <2, 0, 1>, <3, 3, 2> texture { Base } texture { Film } }
