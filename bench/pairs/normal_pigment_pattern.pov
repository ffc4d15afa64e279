// The brightness of a pigment is a pattern of values.
#include "stage.inc"
Bumpy(normal { pigment_pattern { bozo color_map { [0 rgb 0] [0.5 rgb <1, 0.5, 0>] [1 rgb 1] } } 4 scale 0.4 })
