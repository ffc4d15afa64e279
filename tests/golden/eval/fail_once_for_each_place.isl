// A mistake in a loop or macro is told once, and others are not crowded out by it.
#macro Ball(P) sphere { P, 1 pigment { colr 1 } } #end
#for (I, 1, 50) Ball(I*x) #end
#while (1) box { 0, "one" } #end
