// Two shadows with colours, where they overlap and where they do not.
#include "stage.inc"
light_source { <-4, 5, -3> rgb <0.3, 0.5, 1> }
Clear(Ball, material { texture { pigment { rgbf <0.9, 0.5, 0.3, 0.9> } } })
