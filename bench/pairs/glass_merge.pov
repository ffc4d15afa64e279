// A merge has no faces inside.
#include "stage.inc"
Clear(merge { sphere { <-0.4, 1, 0>, 0.9 } sphere { <0.5, 1, 0>, 0.8 } }, Glass)
