// Both shares at once.
#include "stage.inc"
Clear(Block, material { texture { pigment { rgbft <0.9, 0.6, 0.2, 0.4, 0.3> } finish { diffuse 0.6 phong 0.4 } } })
