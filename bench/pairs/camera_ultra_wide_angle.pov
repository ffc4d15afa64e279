// Bent like an ellipse.
#include "stage.inc"
Seen(camera { ultra_wide_angle location <1, 3, -5> look_at y angle 150 right 4/3*x })
