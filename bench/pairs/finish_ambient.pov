// Light that comes from nowhere.
#include "stage.inc"
Finished(finish { ambient <0.3, 0.2, 0.1> diffuse 0.5 })
