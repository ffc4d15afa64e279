// The places where a semicolon can stand, and directives within expressions.
#version 3.7;
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 6), "\n") #end
#declare A = 1;;
Say("two of them", A)
#macro Ended() 5; #end
#declare B = Ended();
Say("the macro's and the declaration's", B)
#declare B = Ended()
Say("the macro's alone", B)
#macro Open() 6 #end
#declare B = Open();
Say("the declaration's alone", B)
#macro Statement() #local L = 7; L; #end
#declare B = Statement();
Say("behind a local", B)
#macro Declares() #declare C = 8; #end
Declares();
Say("behind a macro that declares", C)
#declare V = <1, #declare D = 5; D, 3>;
Say("a declaration within a vector", V.y + D)
#declare V = <#local E = 2; E, #declare F = 3; F, #if (1) 4 #end>;
Say("several within a vector", V.x + 10*V.y + 100*V.z)
#declare V = <#for (I, 1, 3) I, #end 4>;
Say("a loop within a vector", V.x + 10*V.y + 100*V.z + 1000*V.t)
#declare S = sphere { 0, 1 };
#declare Text = "text";
Say("after a string", strlen(Text))
#declare J = #if (0) 1; #else 2; #end
Say("a branch's", J)
union { #declare K = Ended(); sphere { 0, K } sphere { x, #local L = Ended(); L } }
Say("within an object", K)
#macro Calls() Declares() #end
Calls();
Say("behind a macro that calls one that declares", C)
#macro Hides() #local Text = 4; #end
Hides();
#declare V = <1, #declare S = 2;; S, Declares(); 3>;
Say("two within a vector", V.x + 10*V.y + 100*V.z)
#declare R = array[2];
#declare R[1] = 3;;
Say("two behind an element", R[1])
union { sphere { 0, 1 } Declares(); #declare A = 2;; sphere { x, 1 } }
Say("two within an object", A)
