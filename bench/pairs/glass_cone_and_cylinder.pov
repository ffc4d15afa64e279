// Bodies with edges.
#include "stage.inc"
Clear(union { cone { <-0.8, 0, 0>, 0.8, <-0.8, 1.8, 0>, 0.1 } cylinder { <0.9, 0.1, -0.4>, <0.9, 1.5, 0.2>, 0.6 } }, Glass)
