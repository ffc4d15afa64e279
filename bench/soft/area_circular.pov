// A round light.
#include "stage.inc"
Sharp() Floor() Solids()
light_source { <-4, 7, -4> rgb 1 area_light <2.5, 0, 0>, <0, 0, 2.5>, 8, 8 circular jitter }
