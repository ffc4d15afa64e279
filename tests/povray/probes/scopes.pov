// Who sees and changes what.
#version 3.7;
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 6), "\n") #end
#macro Change(P) #declare P = P + 1; #end
#declare A = 1;
Change(A)
Say("by reference", A)
#macro Change_Locally(P) #local P = P + 1; #end
Change_Locally(A)
Say("by reference through local", A)
#declare B = array[3] {1, 2, 3}
Change(B[1])
Say("an element by reference", B[1])
#macro Sum(P) #local S = P + 1; S #end
Say("by value", Sum((A)))
#macro Own() #local A = 10; #declare A = A + 1; A #end
Say("local hides", Own())
Say("hidden", A)
#macro Inner() Seen #end
#macro Outer() #local Seen = 5; Inner() #end
Say("dynamic scope", Outer())
#macro Make() #declare Made = 3; #end
Make()
Say("declared within", Made)
#macro Twice(P) 2*P #end
Say("value of a macro", 3*Twice(4) + 1)
#macro Three() 1, 2, 3 #end
#declare V = <Three()>;
Say("a macro's several values", V.z)
#macro Fib(N)
  #if (N < 2) #local V = N; #else #local V = Fib(N-1) + Fib(N-2); #end
  V
#end
#declare R = Fib(12);
Say("recursion", R)
#macro Redefined() 1 #end
#macro Redefined() 2 #end
Say("redefined", Redefined())
#macro Definer() #macro Defined() 4 #end #end
Definer()
Say("defined within", Defined())
#declare D = B;
#declare D[0] = 9;
Say("arrays are copied", B[0])
#macro In_Array(P) #declare P[2] = 8; #end
In_Array(B)
Say("arrays by reference", B[2])
#ifdef (Nope) Say("ifdef", 1) #else Say("ifdef", 0) #end
#undef A
#ifndef (A) Say("undef", 1) #else Say("undef", 0) #end
Say("defined", defined(B) + 10*defined(B[0]) + 100*defined(Nope))
#declare E = array[2][3];
Say("dimensions", dimensions(E))
Say("size 1", dimension_size(E, 1))
Say("size 2", dimension_size(E, 2))
Say("size of none", dimension_size(E, 3))
#declare F = #if (1) 4; #else 5; #end
Say("a branch as value", F)
Say("index cut off", B[1.9])
