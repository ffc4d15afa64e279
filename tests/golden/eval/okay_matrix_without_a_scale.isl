// As a scale of 0 does, a row of zeros scales by one.
sphere { 0, 1 matrix <2, 0, 0,  0, 0, 0,  0, 0, 1,  1, 0, 0> }
sphere { 0, 1 matrix <0, 0, 0,  0, 0, 0,  0, 0, 0,  1, 0, 0> }
sphere { 0, 1 matrix <1/0, 0, 0,  0, 1, 0,  0, 0, 1,  1, 0, 0> }
