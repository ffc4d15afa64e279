// Half of the horizon.
#include "stage.inc"
Seen(camera { panoramic location <1, 3, -5> look_at y right 4/3*x })
