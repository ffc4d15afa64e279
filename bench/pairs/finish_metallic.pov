// Highlights have the colour of the surface.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.5 phong 0.9 phong_size 10 metallic })
