// #for, #while, #switch, #break.
#version 3.7;
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 6), "\n") #end
#macro Count(From, To, Step)
  #local N = 0;
  #for (I, From, To, Step) #local N = N + 1; #end
  N
#end
Say("tenths", Count(0, 1, 0.1))
Say("thirds", Count(0, 1, 1/3))
Say("downwards", Count(3, 1, -1))
Say("never", Count(3, 1, 1))
Say("once", Count(3, 3, 1))
Say("slack", Count(0, 1-1e-11, 1))
Say("no slack", Count(0, 1-1e-9, 1))
#for (J, 1, 3) #end
Say("variable afterwards", J)
#for (J, 1, 10) #declare J = J + 1; #end
Say("variable changed within", J)
#declare Sum = 0;
#for (J, 1, 10) #if (J > 4) #break #end #declare Sum = Sum + J; #end
Say("break", Sum)
#declare K = 0;
#while (K < 5) #declare K = K + 2; #end
Say("while", K)
#macro Which(N)
  #local R = 0;
  #switch (N)
    #case (1) #local R = R + 1;
    #case (2) #local R = R + 20; #break
    #range (3, 5) #local R = R + 300;
    #else #local R = R + 4000;
  #end
  R
#end
#for (N, 0, 6) Say("switch", Which(N)) #end
Say("switch within slack", Which(1+1e-11))
Say("switch between", Which(4.5))
#macro Early(A) #if (A) #break #end #declare Reached = A; #end
#declare Reached = 7;
Early(1)
Say("break from a macro", Reached)
Early(0)
Say("no break from a macro", Reached)
