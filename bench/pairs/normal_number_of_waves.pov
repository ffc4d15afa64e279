// The global settings say from how many places ripples run.
#include "stage.inc"
global_settings { number_of_waves 3 }
Bumpy(normal { ripples 0.5 frequency 3 scale 0.5 })
