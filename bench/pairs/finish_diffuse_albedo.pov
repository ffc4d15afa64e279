// The share is that of all light, whatever the brilliance.
#include "stage.inc"
Finished(finish { ambient 0 diffuse albedo 0.7 brilliance 0.5 })
