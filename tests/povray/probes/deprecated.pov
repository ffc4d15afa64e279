// Deprecated names are used as others are. The remarks are warnings, which probes do not compare.
#version 3.7;
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 6), "\n") #end
#declare deprecated A = 1;
#declare deprecated once "use another" B = 2;
Say("sum", A + B)
#declare A = 5;
Say("declared again", A)
#macro Writes(P) #declare P = P + 4; #end
Writes(A)
Say("written by reference", A)
#declare deprecated V = <1, 2, 3>;
Say("item", V.y)
#declare deprecated R = array[2] { 1, 2 }
#declare R[1] = 6;
Say("element", R[1])
Writes(R[0])
Say("element by reference", R[0])
Say("dimension", dimension_size(R, 1))
#declare deprecated F = function(x) { x + 1 }
Say("function", F(2))
#declare G = function(x) { F(x) + A }
Say("function in a function", G(2))
#declare deprecated T = "text"
#debug concat(T, "\n")
#declare deprecated I = 3;
#for (I, 1, 2) Say("loop", I) #end
Say("after the loop", I)
#declare deprecated S = spline { 0, 0 1, 4 }
Say("spline", S(0.5).x)
#macro Local() #local deprecated L = 7; Say("local", L) #end
Local()
#ifdef (A) Say("is declared", 1) #end
#undef A
#ifndef (A) Say("is not declared", 1) #end
#declare A = 1;
#declare deprecated "too late" A = 2;
Say("again without", A)
#declare deprecated N = 3;;
Say("two semicolons", N)
