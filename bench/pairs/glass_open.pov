// A shell without ends: a ray may leave where it did not enter.
#include "stage.inc"
Clear(cylinder { 0.1*y, 1.8*y, 1 open }, material { texture { Tint } })
