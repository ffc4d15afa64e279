// Light fades slower with the angle.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.6 brilliance 0.4 })
