// POV-Ray 3.7 stops at the first. Each is told where it runs, once.
#if (1) sphere { 0, #end
#macro A() . #end
A()
#for (I, 1, 3) #declare B = 1 + ; #end
#while (1) #declare C = 2 $ + 3; #break #end
#if (0) #elseif (1 + ) #end
#switch (1) #case (2 == 2) #end
#switch (1) #case (1) } #end
#macro D(X) #if (X) ] #end #end
D(0)
D(1)
#switch (1) 2 #case (1) #end
#if (1) sphere { 0, 1 } #else 1 + + #end
#ifdef (3) #end
#if (1) merge { #else sphere { 0, 1 } #end
