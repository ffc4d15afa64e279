#declare sphere = 1;
#macro Ring(x) #end
#for (clock, 1, 2) #end
