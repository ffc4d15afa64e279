// A macro sees its caller's locals; #declare writes the innermost name that exists.
#version 3.7;
#macro Inner() #debug concat(str(Q, 0, 0), "\n") #end
#macro Outer() #local Q = 5; Inner() #end
Outer()
#ifdef (Q) #debug "leaked\n" #else #debug "gone\n" #end
#declare G = 1;
#macro P() #local G = 2; #declare G = 3; #debug concat(str(G, 0, 0), "\n") #end
P() #debug concat(str(G, 0, 0), "\n")
#macro New() #declare Made = 7; #end
New() #debug concat(str(Made, 0, 0), "\n")
#undef Made #ifdef (Made) #debug "still\n" #else #debug "undefined\n" #end
