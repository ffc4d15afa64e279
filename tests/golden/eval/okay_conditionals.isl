// #elseif after a taken branch is not evaluated; branches not taken are not executed.
#version 3.7;
#if (1) #debug "yes" #elseif (Nothing) #debug "no" #end
#if (0) #declare X = Undeclared; #elseif (2 > 1) #debug " elseif" #else #debug " else" #end
#ifndef (X) #debug " none" #else #debug " some" #end
#declare Y = #if (0) 5; #else 6; #end
#debug concat(" ", str(Y, 0, 0), " ", str(<#if (1) 1 #else 2 #end, 2, 3>.x, 0, 0), "\n")
