// Two fogs, whose colours add up.
#include "stage.inc"
Outdoors()
#ifndef (Without) fog { distance 20 rgb <0.4, 0.3, 0.2> } fog { fog_type 2 distance 8 rgb <0.2, 0.4, 0.3> fog_alt 0.5 } #end
