// Macros change variables of their caller through their parameters.
#version 3.7;
#macro Say(Name, X) #debug concat(Name, " ", str(X, 0, 6), "\n") #end
#macro Add(P, N) #declare P = P + N; #end
#declare A = 1; Add(A, 2) Say("a variable", A)
#declare B = array[2] { 1, 2 } Add(B[1], 3) Say("an element", B[1])
#declare C = array[2] { array[2] { 1, 2 }, array[2] { 3, 4 } }
Add(C[1][0], 5) Say("an element's element", C[1][0])
Add((A), 10) Say("in parentheses", A)
Add(A + 0, 10) Say("an expression", A)
#macro Local(P) #local P = 50; #end
Local(A) Say("local in the macro", A)
#macro Swap(P, Q) #local T = P; #declare P = Q; #declare Q = T; #end
#declare X = 1; #declare Y = 2; Swap(X, Y) Say("swapped", X*10 + Y)
#macro Outer(P) Add(P, 100) #end
Outer(A) Say("through two macros", A)
#macro Twice(P) Add(P, P) #end
#declare X = 4; Twice(X) Say("both arguments", X)
#macro Kind(P) #declare P = <1, 2, 3>; #end
#declare X = 1; Kind(X) Say("another kind", X.z)
#macro Text(P) #declare P = "changed"; #end
#declare S = "text"; Text(S) #debug concat(S, "\n")
#macro Object(P) #declare P = sphere { <5, 0, 0>, 1 } #end
#declare O = sphere { 0, 1 } Object(O) Say("an object", max_extent(O).x)
#macro Fill(P) #for (I, 0, 2) #declare P[I] = I*I; #end #end
#declare E = array[3]; Fill(E) Say("an array", E[2])
#macro Copy(P) #local Q = P; #declare Q[0] = 99; #end
#declare E[0] = 7; Copy(E) Say("a copy in the macro", E[0])
#macro Same(P, Q) #declare P = 1; #declare Q = P + 1; #end
#declare X = 0; Same(X, X) Say("the same twice", X)
#macro Global() #declare G = 3; #end
Global() Say("made in a macro", G)
#macro Hidden() #local H = 5; #macro Inner() #declare H = H + 1; #end Inner() Say("the caller's local", H) #end
Hidden()
Say("gone", defined(H))
#macro Recursive(P, N) #if (N > 0) #declare P = P + N; Recursive(P, N - 1) #end #end
#declare X = 0; Recursive(X, 4) Say("recursive", X)
#macro Undone(P) #undef P #end
#declare X = 3; Undone(X) Say("undef of a parameter", defined(X))
