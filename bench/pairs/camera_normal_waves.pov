// Waves bend the camera's rays.
#include "stage.inc"
#ifdef (Without) View() #else camera { location <1, 3, -5> look_at y right 4/3*x normal { ripples 0.1 frequency 2 scale 0.3 } } #end
Landscape()
