// Wrinkles are noise of ten sizes.
#include "stage.inc"
Bumpy(normal { wrinkles 0.6 scale 0.4 rotate 30 })
