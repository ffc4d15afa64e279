// From 3.8 on objects are white without ambient light, until the scene states a default.
#version 3.8;
sphere { 0, 1 }
sphere { x, 1 pigment { checker } }
#version 3.7;
sphere { 2*x, 1 }
#version 3.8;
#default { finish { diffuse 1 } }
#version 3.7;
sphere { 3*x, 1 }
