// The elements that a macro's body yields are its value: numbers, several arguments, part of a vector.
#version 3.7;
#macro Triple() 1, 2, 3 #end
#macro Sum(A, B) (A + B) #end
#macro Statements(N) #local R = N * 2; R #end
#macro Terminated(N) N + 1; #end
#macro Fib(N) #if (N < 2) N #else (Fib(N - 1) + Fib(N - 2)) #end #end
#macro Early(N) #if (N > 1) #break #end #debug "late " #end
#debug concat(vstr(3, <Triple()>, " ", 0, 0), "\n")
#debug concat(str(2 * Sum(1, 2), 0, 0), " ", str(Sum(1 2), 0, 0), " ", str(Statements(4) + 1, 0, 0), " ", str(Fib(10), 0, 0), "\n")
#declare D = Terminated(4)
#debug concat(str(D, 0, 0), " ", str(max(Triple()), 0, 0), "\n")
Early(2) Early(1) #debug "\n"
