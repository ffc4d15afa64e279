// Shadows that coloured glass filters.
#include "stage.inc"
Sharp() Floor()
sphere { <-0.9, 0.9, 0>, 0.9 pigment { rgbf <0.9, 0.4, 0.3, 0.8> } finish { ambient 0 diffuse 0.2 } }
cylinder { <1.1, 0, 0>, <1.1, 1.7, 0>, 0.5 Look(<0.4, 0.6, 0.5>) }
light_source { <-4, 7, -4> rgb 1 area_light <2, 0, 0>, <0, 0, 2>, 8, 8 jitter }
