// An intersection of two spheres.
#include "stage.inc"
Clear(intersection { sphere { -1.2*z, 1.6 } sphere { 1.2*z, 1.6 } scale 0.9 translate <0, 1, -0.5> }, Glass)
