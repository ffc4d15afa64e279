#macro Forever(N) (1 + Forever(N + 1)) #end
#declare A = Forever(0);
