// Comparison has a tolerance where equality is asked, & and | have one level, both arms of ?: are evaluated.
#version 3.7;
#macro T(X) #debug concat(str(X, 0, 0), " ") #end
T((2<3)) T((3<=3)) T((1!=1)) T((1|0&0)) T((0|1&0)) T(!3) T(!0+!.5) T((5 > 3 > 0)) T((1 ? 2 : 3)) T((1 != 2 ? 3 : 4))
T((1 = 1.00000000001)) T((1 < 1.00000000001)) T(("a" < "b")) T(("a" = "a")) T(("b" <= "a"))
#debug "\n"
