// A flake of 820 balls.
#include "stage.inc"
Sharp() Floor() Flake(3)
light_source { <4, 6, -4> rgb 1 area_light <2, 0, 0>, <0, 2, 0>, 8, 8 jitter }
