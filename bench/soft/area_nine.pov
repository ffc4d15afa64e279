// Nine points a side over the worm.
#include "stage.inc"
Sharp() Floor() Worm()
light_source { <5, 7, -3> rgb <1, 0.95, 0.85> area_light <2, 0, 0>, <0, 0, 2>, 9, 9 jitter }
