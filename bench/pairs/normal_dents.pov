// Dents are few, deep and stretched.
#include "stage.inc"
Bumpy(normal { dents 1 scale <0.3, 0.1, 0.2> })
