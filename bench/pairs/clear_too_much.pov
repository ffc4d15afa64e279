// Shares that add to more than one take light of their own away.
#include "stage.inc"
Clear(Block, material { texture { pigment { rgbft <0.4, 0.6, 0.8, 0.8, 0.4> } finish { ambient 0.2 diffuse 0.6 } } })
