// Many total reflections within a ring.
#include "stage.inc"
Clear(torus { 0.8, 0.35 rotate 30*x translate y }, material { texture { pigment { rgbf <0.76, 0.7, 0.8, 0.5> } finish { diffuse 0.5 } } interior { ior 1.9 } })
