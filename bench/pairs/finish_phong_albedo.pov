// A highlight by its whole light.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.5 phong albedo 0.1 phong_size 60 })
