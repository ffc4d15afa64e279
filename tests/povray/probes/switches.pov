// #switch with ranges, nested, in loops and macros, and what #break leaves.
#version 3.7;
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 6), "\n") #end
#macro Pick(N)
  #switch (N)
    #range (0, 1) #local R = 1; #break
    #range (1, 2) #local R = 2; #break
    #case (5) #case (6) #local R = 3; #break
    #range (8, 7) #local R = 4; #break
    #else #local R = 5;
  #end
  R
#end
Say("the first of two ranges", Pick(1))
Say("the second", Pick(1.5))
Say("within the slack of a range", Pick(2 + 1e-11))
Say("beyond it", Pick(2 + 1e-9))
Say("below the range", Pick(0 - 1e-11))
Say("within the slack of a case", Pick(5 + 1e-11))
Say("two cases", Pick(5) + 10*Pick(6))
Say("a range backwards", Pick(7.5))
Say("none", Pick(100))
#macro Through(N)
  #local R = 0;
  #switch (N)
    #case (1) #local R = R + 1;
    #range (2, 3) #local R = R + 10;
    #case (4) #local R = R + 100;
    #else #local R = R + 1000;
  #end
  R
#end
#for (I, 0, 5) Say("on from a case", Through(I)) #end
#declare Count = 0;
#for (I, 1, 10)
  #switch (I)
    #case (3) #break
    #else #declare Count = Count + 1;
  #end
#end
Say("break leaves the switch alone", Count)
#declare Count = 0;
#for (I, 1, 10)
  #if (I > 4) #break #end
  #for (J, 1, 10) #if (J > I) #break #end #declare Count = Count + 1; #end
#end
Say("break leaves the inner loop alone", Count)
#macro Nested(A, B)
  #switch (A)
    #case (1) #switch (B) #case (1) #local R = 11; #break #case (2) #local R = 12; #break #end #break
    #case (2) #local R = 2; #break
    #else #local R = 0;
  #end
  R
#end
Say("nested", Nested(1, 2))
Say("nested, the outer", Nested(2, 2))
#macro Returns(A) #local R = 1; #while (1) #local R = R + 1; #if (R > A) #break #end #end R #end
Say("while with break", Returns(5))
#declare K = 0;
#while (K < 3) #declare K = K + 1; #switch (K) #case (2) #debug "two " #break #else #debug "other " #end #end
Say("afterwards", K)
#switch (1 + 1) #case (2) Say("a switch of arithmetic", 1) #end
#switch (3) #case (1) Say("no", 1) #end
#declare N = 0;
#for (I, 5, 1, -2) #declare N = N*10 + I; #end
Say("downwards by two", N)
#for (I, 0, 1, 0.3) #end
Say("beyond the end", I)
#declare End = 3; #declare N = 0;
#for (I, 1, End) #declare End = 10; #declare N = N + 1; #end
Say("the end is evaluated once", N)
