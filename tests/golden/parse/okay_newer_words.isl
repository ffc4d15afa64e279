// The words of POV-Ray 3.8 where the text allows no other meaning, and where they are names.
#declare D = dictionary { .Name: 1, ["key"]: sphere { 0, 1 } #if (1) , .x: rgb 1 #end };
#declare D.Name = D["key"].x + D.a.b[2].c;
#declare (A, optional D.b, C[1]) = (1, , "c",);
#macro M(A, optional B, optional, C) (A, B) #end
M(1, , local.X, ) M(, global.Y.z)
#declare L = array mixed[2] { 1, 2 };
#declare L = array mixed { 1 };
#declare L = array;
#declare dictionary = mixed + global.x;
#ifdef (local.A[1]) #undef global.B #end
