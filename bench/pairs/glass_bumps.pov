// Light is bent by the bumps.
#include "stage.inc"
Clear(Ball, material { texture { Tint normal { bumps 0.3 scale 0.3 } } interior { ior 1.5 } })
