// Colours of thin films.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.5 phong 0.5 irid { 0.4 thickness 0.3 } })
