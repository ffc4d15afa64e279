// Two facing mirrors show each other until max_trace_level ends their rays.
#include "stage.inc"
global_settings { max_trace_level 7 }
View() Sun() Haze() Floor()
#declare Glaze = texture { pigment { rgb 0.1 } finish { diffuse 0.2 #ifndef (Without) reflection 0.8 #end } }
box { <-2, 0, 2>, <3, 3, 2.2> texture { Glaze } }
box { <-4, 0, -7.2>, <6, 4, -7> texture { Glaze } }
sphere { y, 0.7 pigment { rgb <1, 0.3, 0.2> } }
