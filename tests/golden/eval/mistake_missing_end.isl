#declare Round = 1;
#if (Round)
  sphere { 0, 2 }
#else
  box { -2, 2 }
plane { y, -2 pigment { rgb 0.7 } }
