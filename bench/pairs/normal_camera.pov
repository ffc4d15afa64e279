// Bumps bend the camera's rays.
#include "stage.inc"
#ifdef (Without) View() #else camera { location <1, 3, -5> look_at y right 4/3*x normal { bumps 0.2 scale 0.2 } } #end
Landscape()
