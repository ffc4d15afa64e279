// Even fog, which hides the background.
#include "stage.inc"
Outdoors()
#ifndef (Without) fog { distance 10 rgb <1, 0.8, 0.6> } #end
