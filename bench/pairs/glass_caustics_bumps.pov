// Faked caustics follow the bumps.
#include "stage.inc"
Clear(Block, material { texture { Tint normal { bumps 0.3 scale 0.3 } } interior { ior 1.33 caustics 1 } })
