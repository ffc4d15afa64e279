// A picture as a clear foil.
#include "stage.inc"
Clear(Block, material { texture { pigment { image_map { png "colours.png" transmit all 0.5 } } } })
