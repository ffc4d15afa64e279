// POV-Ray 3.7 accepts each line with the same values, but for the branch in an argument of a macro, which it refuses.
#declare V = <#if (0) } , 7 #else 1 #end, 2, 3>;
#declare A = #if (0) 5 5 5 } #else 6; #end
#declare B = #switch (2) #case (1) ( #break #case (2) 7; #break #else it's #end
#declare F = function(x) { x #if (0) + * ' #end }
#declare G = function(x) { 0 #for (I, 1, 0) < 1 = } #end + x }
#macro M(P, Q) (P + Q) #end
#declare C = M(#if (0) . } ) #else 1 #end, 2);
#declare L = array[2] { 1, #if (0) } 8 #else 2 #end }
sphere { #if (0) 1 + + ) #end 0, #ifdef (Nope) . #else 1 #end pigment { #if (0) } rgb 2 #end rgb x } }
#debug concat(vstr(3, V, ",", 0, 0), " ", str(A, 0, 0), " ", str(B, 0, 0), " ", str(F(4), 0, 0), " ", str(G(5), 0, 0), " ")
#debug concat(str(C, 0, 0), " ", str(L[1], 0, 0), "\n")
