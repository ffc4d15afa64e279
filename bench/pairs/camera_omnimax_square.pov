// A dome theatre's picture of another shape.
#include "stage.inc"
Seen(camera { omnimax location <1, 3, -5> right x up y look_at y })
