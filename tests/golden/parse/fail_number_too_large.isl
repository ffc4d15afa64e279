#declare A = 1e999;
#declare B = 1e-999;
