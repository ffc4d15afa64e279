// Every point of the light shines by itself.
#include "stage.inc"
Sharp() Floor() Worm()
light_source { <-2, 4, -3> rgb 1 area_light <3, 0, 0>, <0, 0, 3>, 8, 8 area_illumination jitter }
