// Five mistakes in one file are five errors, each where it stands.
sphere { <0, 1, 0>, "wide" }
#declare A = 2 * Undeclared + 1;
box { 0, 1 pigmnt { rgb 1 } }
#declare B = vlength("text");
cone { 0, 1, <0, 2> translate <1, 2, 3> }
