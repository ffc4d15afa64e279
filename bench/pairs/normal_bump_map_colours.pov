// Bumps from a coloured picture about a sphere, by palette or brightness.
#include "stage.inc"
Bumpy(normal { bump_map { png "colours.png" map_type 1 interpolate 2 bump_size 4 } translate y })
