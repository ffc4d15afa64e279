// A pattern with clear, opaque and coloured parts, and its shadow.
#include "stage.inc"
Clear(Ball, material {
  texture { pigment { bozo color_map { [0.4 rgbt 1] [0.5 rgb <1, 0.5, 0>] [0.7 rgbf <0.2, 0.5, 1, 0.7>] } scale 0.3 } finish { diffuse 0.6 } }
})
