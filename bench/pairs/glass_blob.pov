// A drop of water from a blob.
#include "stage.inc"
Clear(blob { threshold 0.5 sphere { <-0.5, 1, 0>, 1.2, 1 } sphere { <0.5, 1.2, 0>, 1.2, 1 } }, material { texture { Tint } interior { ior 1.33 } })
