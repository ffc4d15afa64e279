// Two lights of different colours.
#include "stage.inc"
Sharp() Tiles() Flake(2)
light_source { <-5, 6, -3> rgb <0.7, 0.5, 0.35> area_light <2, 0, 0>, <0, 0, 2>, 8, 8 jitter }
light_source { <5, 5, -4> rgb <0.3, 0.45, 0.7> area_light <1.5, 0, 0>, <0, 1.5, 0>, 4, 4 jitter }
