// Glass that mirrors by its index.
#include "stage.inc"
Clear(Ball, material {
  texture { pigment { rgbf <0.95, 0.9, 0.9, 0.9> } finish { diffuse 0.1 specular 0.6 roughness 0.01 reflection { 0, 1 fresnel } conserve_energy } }
  interior { ior 1.5 }
})
