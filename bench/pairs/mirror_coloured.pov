// A mirror with a colour.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.3 reflection <0.7, 0.4, 0.2> })
