// A row of balls; the third is sharp.
#include "stage.inc"
camera { Eye() focal_point <-0.8, 0.45, 0> aperture 0.6 blur_samples Blur variance 0 }
Tiles() Row()
light_source { <-4, 7, -6> rgb 1 }
