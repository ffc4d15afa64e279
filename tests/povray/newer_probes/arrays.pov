// Arrays of mixed types, without a size, and growing.
#version 3.8;
global_settings { assumed_gamma 1 }
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 6), "\n") #end
#declare M = array mixed[3] { 1, "two", <3, 4, 5> }
Say("mixed", M[0] + M[2].y)
#debug concat("a string of it ", M[1], "\n")
#declare N = array mixed { 1, "two", sphere { 0, 3 } }
Say("its size from the list", dimension_size(N, 1))
Say("an object of it", max_extent(N[2]).x)
#declare L = array { 4, 5, 6, 7 }
Say("of one type", dimension_size(L, 1) + L[3])
#declare G = array;
Say("empty", dimension_size(G, 1) + 10*dimensions(G))
#declare G[3] = 1;
Say("grown", dimension_size(G, 1) + 10*dimensions(G))
Say("which are set", defined(G[0]) + 10*defined(G[3]))
Say("asked beyond its end", defined(G[9]))
#for (I, 0, 19) #declare G[I] = I*I; #end
Say("filled", G[19] + dimension_size(G, 1))
#declare H = G;
#declare H[20] = 5;
Say("a copy grows alone", dimension_size(G, 1) + 100*dimension_size(H, 1))
#declare K = array mixed;
#declare K[0] = 1;
#declare K[1] = "b";
#debug concat("mixed and growing ", K[1], "\n")
#declare T = array mixed[2][2] { { 1, "b" }, { <1, 2, 3>, 4 } }
Say("of two dimensions", T[1][0].z + T[1][1])
#macro Append(A, V) #local N = dimension_size(A, 1); #declare A[N] = V; #end
#declare S = array;
Append(S, 5) Append(S, 6) Append(S, 7)
Say("appended by a macro", dimension_size(S, 1) + 10*S[2])
#declare D = dictionary { .list: array }
#declare D.list[2] = 8;
Say("in a dictionary", dimension_size(D.list, 1) + 10*D.list[2])
