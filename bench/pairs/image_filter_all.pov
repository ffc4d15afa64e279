// A picture as a coloured foil.
#include "stage.inc"
Clear(Block, material { texture { pigment { image_map { png "colours.png" filter all 0.7 } } } })
