// A share of light passes unchanged.
#include "stage.inc"
Clear(Ball, material { texture { pigment { rgbt <1, 0.2, 0.2, 0.5> } finish { diffuse 0.6 } } })
