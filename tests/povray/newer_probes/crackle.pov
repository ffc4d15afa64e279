// Crackle that repeats.
#version 3.8;
global_settings { assumed_gamma 1 }
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 4), "\n") #end
#declare Cells = function { pattern { crackle } }
#declare Repeated = function { pattern { crackle repeat <3, 4, 5> } }
#declare Solid = function { pattern { crackle solid repeat <3, 4, 5> } }
#declare Along = function { pattern { crackle repeat 2*x } }
Say("the first period", Repeated(1.5, 1.5, 2.5) - Cells(1.5, 1.5, 2.5))
Say("repeated", Repeated(4.5, 5.5, 7.5))
Say("below zero", Repeated(-1.5, -2.5, -2.5))
Say("solid", Solid(4.5, 5.5, 2.5))
Say("along one axis", Along(4.5, 1.5, 2.5))
