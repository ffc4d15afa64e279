blob { sphere { 0, 1, 1 } pigment { rgb 1 } sphere { x, 1, 1 } threshold 0.5 }
