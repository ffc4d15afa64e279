// Waves are ripples of different lengths; the place is pushed about by turbulence.
#include "stage.inc"
Bumpy(normal { waves 0.5 frequency 2 phase 0.2 scale 0.5 turbulence 0.2 })
