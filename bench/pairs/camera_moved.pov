// Transforms move the camera.
#include "stage.inc"
Seen(camera { location <0, 2, -6> look_at y right 4/3*x angle 50 rotate <10, -40, 0> translate <0.5, 0.3, 0> })
