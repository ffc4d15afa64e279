// A perspective of 140 degrees.
#include "stage.inc"
Seen(camera { location <1, 3, -5> look_at y angle 140 right 4/3*x })
