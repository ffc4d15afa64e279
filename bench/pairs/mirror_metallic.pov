// What is mirrored takes the colour of the surface.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.3 reflection { 0.8 metallic } metallic })
