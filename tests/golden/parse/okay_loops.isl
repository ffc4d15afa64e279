#while (I < 10) #declare I = I + 1; #end
#for (I, 0, 9) F(I) #end
#for (I, 0, 1, 0.1) #if (I > 0.5) #break #end #end
