// A share of the light is mirrored.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.4 reflection 0.4 })
