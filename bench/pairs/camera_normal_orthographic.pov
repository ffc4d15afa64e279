// Dents bend parallel rays.
#include "stage.inc"
#ifdef (Without) camera { orthographic location <1, 3, -5> right 8*x up 6*y look_at y } #else
camera { orthographic location <1, 3, -5> right 8*x up 6*y look_at y normal { dents 0.2 scale 0.3 } } #end
Landscape()
