// A picture with an alpha channel.
#include "stage.inc"
Clear(Block, material { texture { pigment { image_map { png "alpha.png" } } } })
