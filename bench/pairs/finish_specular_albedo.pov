// A highlight by its whole light.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.5 specular albedo 0.2 roughness 0.01 })
