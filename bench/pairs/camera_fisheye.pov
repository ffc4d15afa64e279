// A fisheye, bent in all directions.
#include "stage.inc"
Seen(camera { fisheye location <1, 3, -5> look_at y angle 140 right 4/3*x })
