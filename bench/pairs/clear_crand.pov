// Compared by mean and spectrum: grain of clear surfaces, which is as strong as on opaque ones.
#include "stage.inc"
Clear(Ball, material { texture { pigment { rgbf <1, 0.8, 0.6, 0.8> } finish { ambient 0 diffuse 0.7 #ifndef (Without) crand 0.1 #end } } })
