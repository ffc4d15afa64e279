// The colour where nothing stands.
#include "stage.inc"
camera { location <0, 2, -5> look_at <0, 1.5, 0> angle 60 right 4/3*x }
light_source { <10, 20, -10> rgb 1 }
#ifndef (Without) background { rgb <0.2, 0.5, 0.8> } #end
sphere { y, 1 pigment { rgb <1, 0.3, 0.2> } }
