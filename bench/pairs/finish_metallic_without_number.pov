// A metal whose highlights and mirrors are coloured at once.
#include "stage.inc"
View() Sun() Haze() Floor()
sphere { y, 1 pigment { rgb <1, 0.75, 0.35> } finish { diffuse 0.3 #ifndef (Without) specular 0.8 roughness 0.02 metallic reflection { 0.2, 0.7 metallic } #end } }
box { <2, 0, 1>, <3, 3, 2> pigment { rgb <0.8, 0.45, 0.3> } finish { diffuse 0.3 #ifndef (Without) phong 0.8 metallic reflection { 0.5 metallic } #end } }
