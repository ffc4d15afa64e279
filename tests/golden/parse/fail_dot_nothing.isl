#declare A = B.;
