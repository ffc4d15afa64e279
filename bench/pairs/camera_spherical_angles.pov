// A part of the sphere.
#include "stage.inc"
Seen(camera { spherical location <1, 3, -5> right 4/3*x look_at y angle 200 100 })
