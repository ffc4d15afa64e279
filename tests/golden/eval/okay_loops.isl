// Loops: #for is inclusive with a slack, its variable survives, #declare inside changes the iteration.
#version 3.7;
#for (I, 0, 1, .1) #debug concat(str(I, 0, 1), " ") #end #debug concat(str(I, 0, 1), "\n")
#for (I, 3, 1, -1) #debug str(I, 0, 0) #end #debug "\n"
#for (I, 0, 3) #if (I = 1) #declare I = 2; #end #debug str(I, 0, 0) #end #debug "\n"
#for (I, 2, 1) #debug "never" #end #debug concat(str(I, 0, 0), "\n")
#declare N = 0; #while (N < 10) #declare N = N + 1; #if (N = 5) #break #end #end #debug concat(str(N, 0, 0), "\n")
#for (I, 1, 3) #for (J, 1, 3) #if (J > I) #break #end #debug concat(str(I, 0, 0), str(J, 0, 0), " ") #end #end #debug "\n"
