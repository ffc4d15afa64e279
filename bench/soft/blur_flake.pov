// A flake before a floor out of focus.
#include "stage.inc"
camera { location <0, 1.4, -4> look_at <0, 0.9, 0> angle 45 focal_point <0, 0.9, -0.6> aperture 0.35 blur_samples Blur variance 0 }
Tiles() Flake(2)
light_source { <-4, 7, -6> rgb 1 }
