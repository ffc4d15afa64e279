// Light is bent on its way into glass and out of it.
#include "stage.inc"
Clear(Ball, Glass)
