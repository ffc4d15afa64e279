// A difference: light leaves through the face of what was taken away.
#include "stage.inc"
Clear(difference { sphere { y, 1 } sphere { <0.5, 1.3, -0.4>, 0.7 } }, Glass)
