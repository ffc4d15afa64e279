#declare A = ;
sphere { <0, 0, 0>, 1 + }
box { <1, 2 , 3 }
#declare t = 3;
rotate <1, 2, 3 > * ;
cylinder { 0, 1, F(2 ) ) }
sphere { 0, 1 }
