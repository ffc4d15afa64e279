#version 3.8;
lemon { 0, 1, x, 2 }
sphere { 0, 1 pigment { potential Blob } }
#declare D = dictionary { }
#declare polarity = 1;   // an ordinary name here
#debug str(polarity, 0, 0)
