// Five points a side: those at the borders weigh half, as in POV-Ray.
#include "stage.inc"
Sharp() Floor() Solids()
light_source { <-4, 7, -4> rgb 1 area_light <2, 0, 0>, <0, 0, 2>, 5, 5 jitter }
