#declare A = B > 3;
