// What is mirrored does not pass.
#include "stage.inc"
Clear(Ball, material {
  texture { pigment { rgbf <0.9, 0.95, 1, 0.9> } finish { diffuse 0.1 reflection { 0.1, 0.9 } conserve_energy } }
  interior { ior 1.3 }
})
