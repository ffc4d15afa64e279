// POV-Ray 3.7 accepts each line: what stands after a #break that is executed is not.
#while (1) #break } it's 1 + + #end
#for (I, 0, 3) #if (I = 1) #break } ) . #end #debug str(I, 0, 0) #end
#switch (1) #case (1) #debug " a" #break } . #case (2) ' #end
#macro A() #debug " b\n" #break . { #end
A()
