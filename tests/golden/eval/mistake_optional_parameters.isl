// Only optional parameters can be left out, and only the last ones without their commas.
#version 3.8;
#macro Last(A, optional B) #end
#macro First(optional A, B) #end
Last(1)
First(1)
First(, )
Last(, 1)
Last(1, 2, 3)
#macro Plain(A, B) #end
Plain(1, )
Plain(1, , )
#declare S = max(1, , 2);
