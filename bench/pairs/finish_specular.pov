// Highlights about the half-way direction.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.5 specular 0.8 roughness 0.02 })
