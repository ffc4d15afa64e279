// Parameters that a call may leave out.
#version 3.8;
global_settings { assumed_gamma 1 }
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 6), "\n") #end
#macro Last(Name, A, optional B) Say(Name, A + 10*defined(local.B)) #end
Last("given", 1, 2)
Last("left out", 1, )
Last("undeclared", 1, Undeclared)
#macro First(Name, optional A, B) Say(Name, B + 10*defined(local.A)) #end
First("first given", 1, 2)
First("first left out", , 2)
#macro Middle(Name, A, optional B, C) Say(Name, A + 10*C + 100*defined(local.B)) #end
Middle("middle left out", 1, , 3)
Middle("middle undeclared", 1, Undeclared, 3)
#macro Both(Name, optional A, optional B) Say(Name, defined(local.A) + 10*defined(local.B)) #end
Both("both left out", , )
Both("the second left out", 1, )
Both("the first left out", , 1)
#declare B = 9;
#macro Shows(Name, A, optional B) Say(Name, B) #end
Shows("an outer one shows through", 1, )
Shows("an outer one hidden", 1, 4)
#declare D = dictionary { .a: 1 }
Last("a key that is there", 1, D.a)
Last("a key that is not", 1, D.z)
Last("a key in brackets that is not", 1, D["z"])
#declare A = array[3] { 1, 2, 3 }
Last("an element", 1, A[2])
#macro Passes(Name, optional X) Last(Name, 1, X) #end
Passes("passed on", 5)
Passes("passed on without a value", )
#macro Default(Name, optional X) #ifndef (local.X) #local X = 7; #end Say(Name, X) #end
Default("the default", )
Default("no default", 8)
Last("an expression", 1, 2 + 3)
Last("a string", 1, "text")
