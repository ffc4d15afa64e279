// An older scene may use them: a remark for each word.
#version 3.7;
#declare D = dictionary { .a: tau, .b: 2*tau }
#declare E = dictionary { .a: 1 }
#macro M(A, optional B) #ifdef (local.B) #debug "B " #end #debug concat(str(A, 0, 4), "\n") #end
M(D.a, ) M(D.b, 1)
