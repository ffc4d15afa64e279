// The object of a pattern takes transforms before its colours.
#declare Ball = sphere { 0, 1 }
box { -2, 2 pigment { object { Ball translate x scale 2 color rgb 1 color rgb x } } }
box { -2, 2 pigment { object { sphere { y, 1 } rotate 90*z rgb 1, rgb x } } }
