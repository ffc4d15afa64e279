// A bubble of air, as it is seen from within water.
#include "stage.inc"
Clear(Ball, material { texture { pigment { rgbf 0.98 } finish { diffuse 0 specular 0.5 } } interior { ior 0.75 } })
