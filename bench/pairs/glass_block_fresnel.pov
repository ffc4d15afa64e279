// Rays that total reflection keeps within a dark block weigh less at each face, and end by adc_bailout.
#include "stage.inc"
Clear(Block, material { texture { pigment { rgbf 0.5 } finish { diffuse 0 reflection { 0, 1 fresnel } } } interior { ior 1.9 } })
