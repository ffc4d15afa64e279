#declare A = 1;
