// `bump_size` replaces the number behind the pattern.
#include "stage.inc"
Bumpy(normal { bumps 0.1 bump_size 1.2 scale 0.2 })
