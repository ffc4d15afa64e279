#declare A = array[2] {1, 2, 3}
#declare B = array[2] {1}
#declare C = array[0]
#declare D = array[2] {1, 2}
#declare E = D[2];
#declare F = array[2]
#declare G = F[0];
#declare H = D[0][0];
