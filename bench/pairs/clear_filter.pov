// Light is filtered by the colour of a thin shell.
#include "stage.inc"
Clear(Ball, material { texture { pigment { rgbf <0.9, 0.5, 0.3, 0.8> } } })
