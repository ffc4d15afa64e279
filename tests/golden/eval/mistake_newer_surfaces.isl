#version 3.8;
ovus { 1, 0.6 distance 0.5 }
ovus { 1, 0.6 radius 1 }
ovus { 1, 0.6 radius }
sphere { 0, 1 pigment { potential { sphere { 0, 1 } } } }
sphere { 0, 1 pigment { potential { isosurface { function { x } } } } }
sphere { 0, 1 pigment { potential 2 } }
sphere { 0, 1 pigment { user_defined { x, y } } }
sphere { 0, 1 pigment { user_defined { function { x } 1 } } }
sphere { 0, 1 normal { user_defined { function { x } } } }
sphere { 0, 1 pigment { marble threshold on } }
camera { user_defined location { function { x } function { y } } }
camera { user_defined direction { 1, 2, 3 } }
camera { location { function { x } } }
