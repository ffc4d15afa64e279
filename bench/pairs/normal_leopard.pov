// Round spots.
#include "stage.inc"
Bumpy(normal { leopard 3 scale 0.05 })
