// The share of ambient light is that of the opaque part.
#include "stage.inc"
Clear(Ball, material { texture { pigment { rgbft <0.9, 0.5, 0.3, 0.3, 0.3> } finish { ambient 0.5 diffuse 0.3 emission 0.2 } } })
