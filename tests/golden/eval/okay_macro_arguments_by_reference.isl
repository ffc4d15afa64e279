// A lone identifier goes by reference, also an array's element; anything else by value.
#version 3.7;
#macro Set(P) #declare P = 7; #end
#macro SetLocal(P) #local P = 8; #end
#declare A = array[2][2] {{1, 2}, {3, 4}}
#declare Q = 1; Set(Q) #debug concat(str(Q, 0, 0), " ")
#declare Q = 1; Set((Q)) #debug concat(str(Q, 0, 0), " ")
#declare Q = 1; Set(+Q) #debug concat(str(Q, 0, 0), " ")
Set(A[0][1]) #debug concat(str(A[0][1], 0, 0), " ")
SetLocal(Q) #debug concat(str(Q, 0, 0), "\n")
