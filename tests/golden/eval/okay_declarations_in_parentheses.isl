// Declarations before an expression in parentheses, as POV-Ray reads them.
#macro Say(V) #debug concat(str(V, 0, 2), "\n") #end
#declare B = ( #local A = 2; A*3 );
Say(B)
#declare C = 2*( #declare D = 4; #local E = D + 1; D*E ) - 1;
Say(C)
Say(< (#local F = 7; F), 2, ( #local G = 1; G + F ) >.z)
#if (( #local H = 3; H > 2 )) Say(1) #end
#macro Square(X) ( #local Y = X; Y*Y ) #end
Say(Square(5) + Square(1 + 1))
#declare P = ( #local Q = <1, 2, 3>; Q.y );
Say(P)
sphere { 0, ( #local R = 0.5; R*2 ) }
