#version 3.8;
#macro M() #local Deep = 1; #debug str(global.Deep, 0, 0) #end
M()
#macro N() #local local.A = 1; #end
N()
#debug str(global.Nowhere, 0, 0)
