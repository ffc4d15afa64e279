// A lying cylinder, from a point.
#include "stage.inc"
Seen(camera { cylinder 2 location <1, 3, -5> look_at y angle 120 right -4/3*x })
