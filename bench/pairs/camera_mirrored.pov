// A right hand: the picture is mirrored.
#include "stage.inc"
Seen(camera { location <1, 3, -5> right -4/3*x look_at y })
