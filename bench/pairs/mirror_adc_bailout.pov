// Rays end whose share is below a tenth.
#include "stage.inc"
global_settings { adc_bailout 0.1 }
Finished(finish { ambient 0 diffuse 0.4 reflection 0.3 })
