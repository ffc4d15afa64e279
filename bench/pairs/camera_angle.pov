// A narrow angle of sight.
#include "stage.inc"
Seen(camera { location <2, 4, -9> look_at y angle 25 right 4/3*x })
