#declare A 5;
