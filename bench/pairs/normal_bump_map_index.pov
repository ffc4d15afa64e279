// Bumps from the numbers of a palette's colours.
#include "stage.inc"
Bumpy(normal { bump_map { png "palette.png" use_index bump_size 0.5 } scale 2 })
