// The rest of a declaration after its mistake gives no second error; a mistake in the next statement does.
#declare A = dictionary { 1 };
#declare B = Nowhere { 1 } [ 2 ];
#declare D = 1 + "a"
sphere { 0, Unknown }
#declare E = 1 + "b", 2;
