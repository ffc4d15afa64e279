// Quilted cloth, whose seams and cushions are curves of their own.
#include "stage.inc"
Bumpy(normal { quilted 0.8 control0 0.5 control1 0.2 scale 0.5 })
