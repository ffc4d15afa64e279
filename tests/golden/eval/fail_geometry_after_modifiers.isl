sphere { translate x 0, 1 }
union { sphere { 0, 1 } translate x sphere { 0, 1 } }
