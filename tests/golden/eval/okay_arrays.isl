// Arrays: sizes, elements, assignment copies the whole.
#version 3.7;
#declare A = array[2][3] {{1, 2, 3}, {4, 5, 6},}
#declare B = A;
#declare B[0][0] = 9;
#debug concat(str(A[0][0], 0, 0), str(B[0][0], 0, 0), str(A[1][2], 0, 0), "\n")
#debug concat(str(dimensions(A), 0, 0), str(dimension_size(A, 1), 0, 0), str(dimension_size(A, 2), 0, 0), "\n")
#declare N = array[3]
#declare N[1] = 5;
#debug concat(str(defined(N[0]), 0, 0), str(defined(N[1]), 0, 0), str(defined(Nothing), 0, 0), str(N[0.9999999999999], 0, 0), "\n")
