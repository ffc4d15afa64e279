#declare scale = 3;
sphere { 0, scale }
