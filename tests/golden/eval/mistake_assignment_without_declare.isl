#declare Size = 1;
Size = 2;
sphere { 0, Size }
