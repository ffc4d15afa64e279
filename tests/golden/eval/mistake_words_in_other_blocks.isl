sphere { 0, 1 texture { rgb 1 } }
sphere { 0, 1 pigment { rgb 1 ior 1.5 } }
sphere { 0, 1 finish { rgb 1 } }
sphere { 0, 1 texture { phong 1 } }
sphere { 0, 1 phong 1 }
sphere { 0, 1 pigment { rgb 1 bumps 0.5 } }
sphere { 0, 1 pigment { rgb 1 finish { phong 1 } } }
sphere { 0, 1 finish { phong 1 camera { location z } } }
light_source { 0, rgb 1 assumed_gamma 1 }
camera { location z spotlight }
union { sphere { 0, 1 } scale 2 box { 0, 1 } }
sphere { 0, 1 sphere { 0, 2 } }
max_trace_level 5
while (1)
sphere { 0, 1 translate 1, 2, 3 }
