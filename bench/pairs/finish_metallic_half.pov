// Half of a highlight has the colour of the surface.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.4 specular 0.9 roughness 0.1 metallic 0.5 })
