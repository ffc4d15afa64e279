// The whole sphere.
#include "stage.inc"
Seen(camera { spherical location <1, 3, -5> look_at y right 4/3*x })
