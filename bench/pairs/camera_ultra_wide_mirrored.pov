// Mirrored, and bent beyond the half circle.
#include "stage.inc"
Seen(camera { ultra_wide_angle location <1, 3, -5> angle 300 right -4/3*x up y look_at y })
