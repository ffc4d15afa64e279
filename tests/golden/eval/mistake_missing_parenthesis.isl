#declare Width = sin(pi/4;
sphere { 0, Width }
