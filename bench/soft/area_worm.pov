// A light of 4x4 points over a blob of 40.
#include "stage.inc"
Sharp() Tiles() Worm()
light_source { <-3, 8, -5> rgb 1 area_light <3, 0, 0>, <0, 0, 3>, 4, 4 jitter }
