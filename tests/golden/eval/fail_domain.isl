#declare A = sqrt(-1);
#declare B = ln(0);
#declare C = mod(1, 0);
#declare D = rand(7);
#declare E = substr("abc", 3, 2);
#declare F = sin("x");
#declare G = sin(1, 2);
