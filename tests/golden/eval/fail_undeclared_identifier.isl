#declare Radius = 2;
sphere { 0, Raduis }
