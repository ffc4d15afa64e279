// A square light over solids.
#include "stage.inc"
Sharp() Floor() Solids()
light_source { <-4, 7, -4> rgb 1 area_light <2, 0, 0>, <0, 0, 2>, 8, 8 jitter }
