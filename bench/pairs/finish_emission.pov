// Light of its own, which needs no lamp.
#include "stage.inc"
Finished(finish { ambient 0 emission <0.1, 0.2, 0.3> diffuse 0.5 })
