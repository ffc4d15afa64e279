#declare A = <1, 2, 3>;
#declare B = <1 -2 3>;
#declare C = <1, 2,>;
#declare D = <(1 > 2), A.x, -B.y>;
#declare E = <x*2, #if (1) 3 #else 4 #end>;
