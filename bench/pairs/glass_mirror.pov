// Glass that mirrors by the angle.
#include "stage.inc"
Clear(Ball, material { texture { Tint finish { reflection { 0.1, 0.7 } } } interior { ior 1.5 } })
