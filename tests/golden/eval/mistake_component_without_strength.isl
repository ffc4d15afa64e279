blob { threshold 0.5 sphere { 0, 1 } sphere { x, 1 } pigment { rgb 1 } }
