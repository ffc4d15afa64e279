// A soft shadow out of focus: the samples of both are shared.
#include "stage.inc"
camera { Eye() focal_point <-0.8, 0.45, 0> aperture 0.5 blur_samples Blur variance 0 }
Tiles() Row()
light_source { <-4, 7, -6> rgb 1 area_light <2, 0, 0>, <0, 0, 2>, 4, 4 jitter }
