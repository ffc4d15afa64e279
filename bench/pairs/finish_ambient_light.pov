// The global settings colour all light that comes from nowhere.
#include "stage.inc"
global_settings { ambient_light rgb <2, 1, 0.5> }
Finished(finish { ambient 0.2 diffuse 0.5 })
