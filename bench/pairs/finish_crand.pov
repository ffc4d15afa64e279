// Compared by mean and spectrum: grain is random.
#include "stage.inc"
Finished(finish { ambient 0 diffuse 0.7 crand 0.1 })
