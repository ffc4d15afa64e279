// A square light over a flake of 91 balls.
#include "stage.inc"
Sharp() Floor() Flake(2)
light_source { <-4, 7, -4> rgb 1 area_light <2.5, 0, 0>, <0, 0, 2.5>, 8, 8 jitter }
