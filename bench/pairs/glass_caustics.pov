// Faked caustics light the middle of a shadow.
#include "stage.inc"
Clear(Ball, material { texture { Tint } interior { ior 1.5 caustics 0.7 } })
