// Two colours of a palette let light through.
#include "stage.inc"
Clear(Block, material { texture { pigment { image_map { png "palette.png" filter 1, 0.9 transmit 2, 0.7 } } } })
