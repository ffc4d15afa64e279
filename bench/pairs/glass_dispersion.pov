// Refraction parts colours.
#include "stage.inc"
Clear(Ball, material { texture { Tint } interior { ior 1.5 dispersion 1.1 dispersion_samples 7 } })
