Radius = 3;
