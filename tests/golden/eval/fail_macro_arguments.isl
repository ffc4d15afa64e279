#macro Two(A, B) #end
Two(1)
Two(1, 2, 3)
#declare A = 2 * Two(1, 2);
