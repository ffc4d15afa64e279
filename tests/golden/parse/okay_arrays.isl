#declare A = array[2][3] { { 1, 2, 3 }, { 4, 5, 6 }, }
#declare B = array[N + 1]
#declare A[0][1] = "text";
#undef A
