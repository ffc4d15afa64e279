// Grooves between tiles of hexagons.
#include "stage.inc"
Bumpy(normal { pavement number_of_sides 6 number_of_tiles 3 pattern 2 bump_size 1 scale 0.31 })
