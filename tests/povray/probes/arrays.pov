// Arrays: sizes, copies, elements of all kinds, elements that are not set.
#version 3.7;
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 6), "\n") #end
#declare A = array[3] { 1, 2, 3 }
#declare B = array[2][3] { { 1, 2, 3 }, { 4, 5, 6 } }
#declare C = array[2][2][2] { { { 1, 2 }, { 3, 4 } }, { { 5, 6 }, { 7, 8 } } }
Say("two dimensions", B[1][2])
Say("three dimensions", C[1][0][1])
Say("dimensions", dimensions(A) + 10*dimensions(B) + 100*dimensions(C))
Say("sizes", dimension_size(B, 1) + 10*dimension_size(B, 2))
Say("an index of arithmetic", A[A[0] + 1])
Say("an index cut off", A[1.99])
Say("an index nearly whole", A[0.99999999999])
#declare N = 2;
#declare D = array[N*2];
Say("a size of arithmetic", dimension_size(D, 1))
#declare E = array[2.9];
Say("a size cut off", dimension_size(E, 1))
#declare D[1] = 7;
Say("one that is set", D[1])
Say("which are set", defined(D[0]) + 10*defined(D[1]))
#ifdef (D[0]) Say("ifdef", 1) #else Say("ifdef", 0) #end
#ifndef (D[1]) Say("ifndef", 1) #else Say("ifndef", 0) #end
#declare D[1] = D[1] + 1;
Say("changed", D[1])
#declare F = A;
#declare F[0] = 10;
Say("a copy", A[0] + F[0])
#declare V = array[2] { <1, 2, 3>, <4, 5, 6> }
Say("a coordinate of an element", V[1].y)
#declare S = array[3] { "one", "two", concat("th", "ree") }
#debug concat(S[2], S[0], "\n")
#declare K = array[2] { color rgb <1, 0.5, 0.25>, rgbt 0.5 }
Say("a colour's item", K[0].green + K[1].transmit)
#declare O = array[2] { sphere { 0, 1 }, box { -1, 1 } }
Say("objects", max_extent(O[0]).x + max_extent(O[1]).y)
#declare G = array[2] { function (a) { a*2 }, function (a) { a*3 } }
Say("functions", G[0](1) + G[1](1))
#declare H = array[2] { array[2] { 1, 2 }, array[2] { 3, 4 } }
Say("arrays in arrays", H[1][0])
#macro Sum(P) #local R = 0; #for (I, 0, dimension_size(P, 1) - 1) #local R = R + P[I]; #end R #end
Say("through a macro", Sum(A))
#macro Set(P, I, X) #declare P[I] = X; #end
Set(A, 2, 30)
Say("set by a macro", A[2])
#macro Make(Size) #local R = array[Size]; #for (I, 0, Size - 1) #local R[I] = I*I; #end R #end
#declare M = Make(4)
Say("made by a macro", M[3])
#declare T = array[2] { 1 2 }
Say("no commas", T[1])
#declare U = array[2] { 1, 2, }
Say("a comma at the end", U[1])
#undef M
Say("undefined", defined(M))
