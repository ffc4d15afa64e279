// A strip of light: 16 points by one.
#include "stage.inc"
Sharp() Floor() Solids()
light_source { <-1, 5, -5> rgb 1 area_light <6, 0, 0>, <0, 0, 1>, 16, 1 jitter }
