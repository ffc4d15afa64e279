// Cases fall through, as in C.
#version 3.7;
#switch (3) #case (1) #debug "one" #break #range (2, 3) #debug "two-three" #case (4) #debug "four" #break #else #debug "else" #end #debug "\n"
#switch (1) #case (1) #debug "a" #case (2) #debug "b" #break #case (3) #debug "c" #end #debug "\n"
#switch (9) #case (1) #debug "no" #break #else #debug "default" #end #debug "\n"
#switch (3) #case (3) #debug "three" #else #debug " and else" #end #debug "\n"
