// POV-Ray 3.7 accepts each line and says 1 to 6.
#if (1) #debug "1 " #else } { it's 1 + + #end
#if (1) #debug "2 " #elseif (1 + + ') } #end
#if (1) #debug "3 " #elseif #end
#if (0) } #elseif (1) #debug "4 " #else { #end
#ifndef (Nope) #debug "5 " #else #macro Q( #end . #end
#if (0) ( #elseif (0) [ #else #debug "6\n" #end
