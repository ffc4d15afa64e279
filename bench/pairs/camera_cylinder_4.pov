// A lying cylinder, from its axis.
#include "stage.inc"
Seen(camera { cylinder 4 location <1, 3, -5> look_at y angle 120 right 6*x rotate 10*y })
