sphere { 0, 1 pigment { rgb 1, 0.5, 0 } }
