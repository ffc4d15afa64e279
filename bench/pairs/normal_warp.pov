// Bumps in a space that is repeated and mirrored, then stirred.
#include "stage.inc"
Bumpy(normal { bumps 0.6 scale 0.2 warp { repeat 0.7*x flip y } warp { turbulence 0.3 } })
