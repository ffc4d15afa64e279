sphere { 0, 1 pigment { rgb 1 phong 0.5 } }
