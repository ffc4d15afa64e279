light_source { <4, 4, -4> rgb <1, 0> }
sphere { 0, 1 pigment { color rgb <0.5, 0.2> } }
