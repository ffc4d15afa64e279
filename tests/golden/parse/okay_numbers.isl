#declare A = array[6] { 1, 1., .5, 1e-3, 1.5E+2, 007 }
