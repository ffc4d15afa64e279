// A film on a mirror.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.3 reflection 0.5 irid { 0.6 thickness 0.4 } })
