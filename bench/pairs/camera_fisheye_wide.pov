// A fisheye that sees behind itself.
#include "stage.inc"
Seen(camera { fisheye location <1, 3, -5> look_at y angle 300 right 4/3*x })
