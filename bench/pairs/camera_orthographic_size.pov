// Parallel rays; the picture is as large as `right` and `up`.
#include "stage.inc"
Seen(camera { orthographic location <1, 3, -5> right 8*x up 6*y look_at y })
