// Shells about the origin with a scallop wave.
#include "stage.inc"
Bumpy(normal { onion 0.6 scallop_wave scale 0.4 })
