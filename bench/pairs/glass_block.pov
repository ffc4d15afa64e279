// Total reflection within a block.
#include "stage.inc"
Clear(Block, material { texture { Tint } interior { ior 1.8 } })
