union { translate x sphere { 0, 1 } }
difference { box { 0, 1 } scale 2 sphere { 0, 1 } }
union { translate x scale 2 }
