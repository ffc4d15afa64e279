// Something near the lens, far out of focus.
#include "stage.inc"
camera { Eye() focal_point <0, 0.7, 0> aperture 0.5 blur_samples Blur variance 0 }
Tiles() Solids()
torus { 0.35, 0.06 rotate 70 * x translate <-0.7, 1.9, -3.9> Look(<0.9, 0.8, 0.2>) }
light_source { <-4, 7, -6> rgb 1 }
