// The values of macros: numbers, parts of expressions, arguments, objects.
#version 3.7;
#macro Say(Name, X) #debug concat(Name, " ", str(X, 0, 6), "\n") #end
#macro Five() 5 #end
Say("a number", Five())
Say("in arithmetic", 2*Five() + 1)
#macro Sum_P(P, Q) (P + Q) #end
Say("in parentheses", 2*Sum_P(1, 2))
#macro Two() 1, 2 #end
#macro Third(P, Q, R) P + 10*Q + 100*R #end
Say("two arguments", Third(Two(), 3))
#macro Vec(A) <A, A*2, A*3> #end
Say("a vector", Vec(2).z)
#macro Coordinates() 1, 2, 3 #end
#declare V = <Coordinates()>; Say("coordinates", V.y)
#macro Text() "text" #end
#debug concat(Text(), "\n")
#macro Ball(R) sphere { 0, R } #end
#declare B = Ball(3) Say("an object", max_extent(B).y)
#declare C = object { Ball(2) scale 2 } Say("an object in a block", max_extent(C).y)
#macro Move(D) translate D*x scale 2 #end
#declare C = sphere { 0, 1 Move(3) } Say("modifiers", max_extent(C).x)
#macro Centre_And_Radius() 0, 4 #end
#declare C = sphere { Centre_And_Radius() } Say("a sphere's numbers", max_extent(C).x)
#macro Many(N) #for (I, 1, N) sphere { I*x, 0.5 } #end #end
#declare C = union { Many(4) } Say("many objects", max_extent(C).x)
#macro Fact(N) #if (N < 2) #local R = 1; #else #local R = N*Fact(N - 1); #end R #end
Say("factorial", Fact(10))
#macro Even(N) #if (N = 0) #local R = 1; #else #local R = Odd(N - 1); #end R #end
#macro Odd(N) #if (N = 0) #local R = 0; #else #local R = Even(N - 1); #end R #end
Say("one calls the other", Even(8) + 10*Odd(8))
#macro No_Commas(P Q R) P*Q*R #end
Say("no commas", No_Commas(2 3 4))
#macro Array() array[3] { 7, 8, 9 } #end
#declare D = Array() Say("an array", D[2])
#macro Func(K) function (x) { K*x } #end
#declare F = Func(3) Say("a function", F(4))
#macro Colour() color rgb <1, 0.5, 0.25> #end
#declare E = Colour(); Say("a colour", E.blue)
#macro Condition(X) (X > 3) #end
#if (Condition(4)) Say("a condition", 1) #else Say("a condition", 0) #end
#macro Index() 1 #end
Say("an index", D[Index()])
#macro Nothing() #end
Nothing()
