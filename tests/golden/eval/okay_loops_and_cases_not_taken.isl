// POV-Ray 3.7 accepts each line and says 2 5 5 6 6.
#while (0) } it's 1 + + #end
#for (I, 1, 0) } it's . #macro Q( #end #end
#switch (2) #case (1) } ' #break #case (2) #debug "2 " #break #else { # } #end
#switch (5) #range (1, 2) ( #break #range (4, 6) #debug "5 " #break #case (3 + ) ] #end
#switch (5) #case (5) #debug "5 " #break #case (1 = ) #range (1 , ( #else . . #end
#switch (7) #case (1) } #case (2) 1 + #range (3, 4) it's #end
#declare N = 0;
#while (N < 2) #if (N > 2) } #end #debug "6 " #declare N = N + 1; #end
#debug "\n"
