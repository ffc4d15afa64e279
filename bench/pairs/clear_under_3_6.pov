// Below language version 3.7 what a filter takes is counted by its colour.
#include "stage.inc"
#version 3.6;
Clear(Block, material { texture { pigment { rgbft <0.2, 0.4, 0.6, 0.5, 0.3> } finish { ambient 0.4 diffuse 0.5 } } })
