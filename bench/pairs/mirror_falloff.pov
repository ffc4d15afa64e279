// How the reflectivity goes from one side to the other.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.4 reflection { 0.8, 0.1 falloff 4 } })
