// Textures of a map are shaded each with rays of its own.
#include "stage.inc"
Clear(Ball, material {
  texture {
    gradient y
    texture_map {
      [0.3 pigment { rgb <1, 0.6, 0.2> } finish { reflection 0.3 }]
      [0.6 pigment { rgbf <0.6, 0.9, 1, 0.9> } finish { diffuse 0.2 }]
    }
  }
})
