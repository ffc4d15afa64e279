// Light fades faster with the angle.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.7 brilliance 3 })
