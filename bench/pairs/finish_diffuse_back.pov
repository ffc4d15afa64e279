// The second share of `diffuse` is of light from behind.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.5, 0.4 })
