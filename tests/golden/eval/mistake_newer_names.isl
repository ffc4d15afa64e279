// Words of version 3.8 are reserved in a scene that states it.
#version 3.8;
#declare tau = 3;
#macro optional(A) #end
#macro Of(grey) #end
#for (mixed, 1, 2) #end
#declare (A, global) = (1, 2);
#version 3.7;
#declare mixed = 1;
