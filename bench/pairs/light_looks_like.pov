// A lamp with a body, which throws no shadow.
#include "stage.inc"
Lit(light_source { <0.5, 2.6, -1.2> rgb 1 looks_like { sphere { 0, 0.3 pigment { rgb <1, 0.9, 0.6> } finish { emission 1 } } } })
