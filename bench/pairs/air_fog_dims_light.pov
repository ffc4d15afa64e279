// Fog dims light on its way from a lamp with `media_attenuation`.
#include "stage.inc"
camera { location <0, 2, -5> look_at <0, 1.5, 0> angle 60 right 4/3*x }
light_source { <4, 6, -6> rgb 2 #ifndef (Without) media_attenuation on #end }
background { rgb <0.2, 0.2, 0.8> }
fog { distance 15 rgb <1, 0.8, 0.6> }
plane { y, -0.001 pigment { rgb <0.2, 0.4, 0.6> } }
sphere { y, 1 pigment { rgb <1, 0.3, 0.2> } }
sphere { <3, 1, 8>, 1 pigment { rgb <1, 0.3, 0.2> } }
