// More is mirrored at grazing angles.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.4 reflection { 0.05, 0.9 falloff 2 } })
