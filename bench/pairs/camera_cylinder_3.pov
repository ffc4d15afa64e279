// An upright cylinder, from its axis.
#include "stage.inc"
Seen(camera { cylinder 3 location <1, 3, -5> look_at y angle 120 right 4/3*x up 4*y })
