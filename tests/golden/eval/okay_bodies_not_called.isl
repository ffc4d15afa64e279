// POV-Ray 3.7 accepts each macro; it reads the body of none.
#macro A() . #end
#macro B() 1 + + it's $ #end
#macro C() sphere { #end
#macro D() } ) ] #end
#macro E() #if (1) sphere { #else } #end #for (I, 1 #end #end
#macro F() #macro G( #end #end
#macro H(X) dictionary { ["a"]: X } #end
#macro I() #iff (1) #end
#debug "defined\n"
