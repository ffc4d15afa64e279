#declare Outer =
#declare Pigment = pigment { rgb <1, 0.5, 0> }
#declare Number = 2;
texture { pigment { Pigment } finish { diffuse Number / 4 } }
#declare A = #declare B = Number; B + 1;
sphere { 0, A texture { Outer } }
