#declare A = sqrt(-1);
#declare B = sqrt(1 - 1.001);
#declare D = 0.3 - (0.1 + 0.2);
#declare C = sqrt(D);
#declare E = sqrt(-1e-300);
