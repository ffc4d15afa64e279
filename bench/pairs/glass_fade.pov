// Light fades on its way through a body, by a power of two.
#include "stage.inc"
Clear(Block, material {
  texture { pigment { rgbt 1 } finish { diffuse 0 } }
  interior { ior 1.4 fade_distance 1 fade_power 2 fade_color <0.2, 0.7, 0.4> }
})
