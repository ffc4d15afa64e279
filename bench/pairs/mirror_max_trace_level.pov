// Rays end after two reflections.
#include "stage.inc"
global_settings { max_trace_level 3 }
Finished(finish { ambient 0 diffuse 0.4 reflection 0.6 })
