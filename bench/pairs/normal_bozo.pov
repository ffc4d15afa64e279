// As `bozo`, smooth noise is a pattern of values, unlike `bumps`.
#include "stage.inc"
Bumpy(normal { bozo 2 scale 0.3 })
