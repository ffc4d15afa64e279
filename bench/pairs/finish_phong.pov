// Highlights about the mirrored direction.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.5 phong 0.8 phong_size 20 })
