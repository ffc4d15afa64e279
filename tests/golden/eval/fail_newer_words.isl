#version 3.8;
lemon { 0, 1, x, 2 }
#declare P = pigment { polarity 2 }
mixed
