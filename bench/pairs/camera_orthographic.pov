// Parallel rays; the picture is as large as a perspective one where it looks at.
#include "stage.inc"
Seen(camera { orthographic location <1, 3, -5> look_at y right 4/3*x angle 55 })
