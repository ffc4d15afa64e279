// Soft shadows in a mirror.
#include "stage.inc"
Sharp() Solids()
plane { y, 0 pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0.05 diffuse 0.5 reflection 0.4 } }
light_source { <-4, 7, -4> rgb 1 area_light <2, 0, 0>, <0, 0, 2>, 8, 8 jitter }
