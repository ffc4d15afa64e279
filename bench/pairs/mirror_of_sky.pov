// Mirrors show the sky sphere.
#include "stage.inc"
View() Sun()
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [1 rgb <0.1, 0.3, 0.8>] } } }
Still_life(finish { ambient 0 diffuse 0.3 #ifndef (Without) reflection 0.6 #end })
