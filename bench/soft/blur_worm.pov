// The worm, sharp in front.
#include "stage.inc"
camera { location <0, 2.2, -5> look_at <0, 0.9, 0> angle 45 focal_point <0, 0.6, -1.4> aperture 0.8 blur_samples Blur variance 0 }
Floor() Worm()
light_source { <-4, 7, -6> rgb 1 }
