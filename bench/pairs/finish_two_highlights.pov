// Both kinds of highlights on one surface, from two lamps.
#include "stage.inc"
light_source { <-4, 5, -3> rgb <0.3, 0.5, 1> }
Finished(finish { ambient 0 diffuse 0.4 phong 0.7 phong_size 10 specular 0.7 roughness 0.005 })
