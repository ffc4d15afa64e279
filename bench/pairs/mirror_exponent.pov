// A power of what is mirrored.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.3 reflection { 0.6 exponent 2 } })
