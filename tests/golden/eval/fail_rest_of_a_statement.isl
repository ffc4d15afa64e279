// What is left of a declaration after its mistake is no second one; what follows it is.
#declare A = dictionary { 1 };
#declare B = Nowhere { 1 } [ 2 ];
#declare D = 1 + "a"
sphere { 0, Unknown }
#declare E = 1 + "b", 2;
