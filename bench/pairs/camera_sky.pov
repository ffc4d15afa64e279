// The horizon leans.
#include "stage.inc"
Seen(camera { location <1, 3, -5> right 4/3*x sky <0.5, 1, 0> look_at y })
