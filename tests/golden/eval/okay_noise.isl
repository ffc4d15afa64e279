// Noise of the three generators, and turbulence.
#declare Noise = function { internal(78) }
#for (G, 1, 3) #debug concat(str(Noise(0.3, -20.2, 7.1, G), 0, 12), "\n") #end
#debug concat(vstr(3, vturbulence(2, 0.5, 6, <0.1,0.2,0.3>), " ", 0, 9), "\n")
