// A film on glass colours what total reflection keeps within.
#include "stage.inc"
Clear(Block, material { texture { pigment { rgbf <0.9, 0.9, 0.9, 0.95> } finish { diffuse 0.1 irid { 0.5 thickness 0.3 } } } interior { ior 1.6 } })
