// Several names from one tuple of values.
#version 3.8;
global_settings { assumed_gamma 1 }
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 6), "\n") #end
#declare (A, B) = (1, 2);
Say("two", A + 10*B)
#declare (A, B, C) = (1, "two", sphere { 0, 1 });
#debug concat("a string ", B, "\n")
Say("an object", max_extent(C).y)
#declare (A, B) = (rgb <1, 0.5, 0>, texture { pigment { rgb 1 } });
Say("a colour", A.green)
#declare (A, B) = (<1, 2> + <3, 4>, (1 = 1 ? 2 : 3));
Say("expressions", A.y + 10*B)
#macro Pair() #local A = 10; #local B = A + 1; (A, B) #end
#declare (P, Q) = Pair();
Say("of a macro", P + 100*Q)
#declare (A, B) = Pair()
Say("names like the macro's own", A + 100*B)
#macro Divide(X, Y) (int(X/Y), mod(X, Y)) #end
#declare (Quotient, Rest) = Divide(17, 5);
Say("with arguments", Quotient + 10*Rest)
#declare (A, B) = (1, 2);
#declare (A, B) = (B, A);
Say("from left to right", A + 10*B)
#declare List = array[2];
#declare D = dictionary { .a: 1 }
#declare (List[1], D.b, D["c"]) = (3, 4, 5);
Say("elements and keys", List[1] + 10*D.b + 100*D.c)
#declare B = 5;
#declare (A, optional B) = (1, Undeclared);
Say("an optional one keeps its value", B)
#declare (A, optional Fresh) = (1, );
Say("an optional one is not declared", defined(Fresh))
#declare (optional First, Second) = (, 2);
Say("the first left out", Second + 10*defined(First))
#declare (A, optional Given) = (1, 7);
Say("an optional one with a value", Given)
#declare (Single) = (5);
Say("one", Single)
#macro Locals() #local (L, M) = (3, 4); Say("locals", L + 10*M) #end
Locals()
Say("gone", defined(L))
#declare (Square, B) = (function (x) { x*x }, 3);
Say("a function", Square(B))
