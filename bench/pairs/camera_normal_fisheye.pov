// Bumps bend the rays of a fisheye.
#include "stage.inc"
#ifdef (Without) camera { fisheye location <1, 3, -5> look_at y angle 140 right 4/3*x } #else
camera { fisheye location <1, 3, -5> look_at y angle 140 right 4/3*x normal { bumps 0.1 scale 0.2 } } #end
Landscape()
