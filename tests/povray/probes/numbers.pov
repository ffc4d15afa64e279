// Functions of numbers and vectors, and the random streams.
#version 3.7;
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 12), "\n") #end
#macro Say3(Name, V) #debug concat(Name, " ", vstr(3, V, " ", 0, 12), "\n") #end
Say("abs ceil floor", abs(-2.5) + 10*ceil(1.2) + 100*floor(-1.2))
Say("ceil of a negative", ceil(-0.5))
Say("int", int(-2.7) + 10*int(2.7))
Say("int of much", int(3e9))
Say("div", div(-7, 2) + 10*div(7.9, 2.1))
Say("div by zero", div(5, 0))
Say("mod", mod(-7, 3) + 10*mod(5.5, 2) + 100*mod(7, -3))
Say("roots and powers", sqrt(2) + pow(2, 0.5) + pow(-8, 3))
Say("power of zero", pow(0, -1))
Say("exp ln log", exp(1) + ln(10) + log(2))
Say("sin cos tan", sin(1) + cos(2) + tan(0.5))
Say("asin acos atan", asin(0.3) + acos(0.3) + atan(2))
Say("atan2", atan2(1, -1) + atan2(-1, -1))
Say("acos beyond", acos(2) + asin(-1.5))
Say("sinh cosh tanh", sinh(1) + cosh(1) + tanh(1))
Say("asinh acosh atanh", asinh(1) + acosh(2) + atanh(0.5))
Say("degrees radians", degrees(1) + radians(1))
Say("min max", min(3, 1, 2) + 10*max(3, 1, 2) + min(5))
Say("select of three", select(-1, 1, 2) + 10*select(0, 1, 2))
Say("select of four", select(-1, 1, 2, 3) + 10*select(0, 1, 2, 3) + 100*select(1e-12, 1, 2, 3))
Say("bits", bitwise_and(7, 5) + 10*bitwise_or(1, 2, 4) + 100*bitwise_xor(7, 5, 1))
Say("bits of negatives", bitwise_and(-1, 5.9))
Say("bits of much", bitwise_or(1.5e10, 1))
Say("division by zero", -1/0)
Say("pi", pi)
Say("truths", true + on + yes + false + off + no)
Say("vlength vdot", vlength(<3,4>) + vdot(<1,2,3>, 2) + vlength(2))
Say3("vcross", vcross(<1,2>, 3))
Say3("vnormalize", vnormalize(<3,4>))
Say3("vrotate", vrotate(<1,2,3>, <30,40,50>))
Say3("vrotate of y", vrotate(z, 90*y))
Say3("vaxis_rotate", vaxis_rotate(<1,2,3>, <1,1,0>, 30))
Say3("vturbulence", vturbulence(2, 0.5, 6, <0.1,0.2,0.3>))
// POV-Ray turns in single precision here: the last digits depend on how a compiler orders it.
#debug concat("vturbulence of single precision ", vstr(3, vturbulence(3, 0.4, 3.7, <-1.3,7.7,100.2>), " ", 0, 6), "\n")
Say3("vturbulence of no octaves", vturbulence(2, 0.5, 0, 0.5))
Say3("vturbulence of too many", vturbulence(2, 0.5, 20, 0.5))
#declare S = seed(1);
#declare T = seed(0);
Say("rand 1", rand(S))
Say("rand 2", rand(S))
Say("rand of another", rand(T))
Say("rand 3", rand(S))
#for (I, 1, 1000) #declare R = rand(S); #end
Say("rand 1003", R)
#declare W = seed(-1);
Say("rand of minus one", rand(W))
#declare W = seed(2.7);
Say("rand of a fraction", rand(W))
#declare W = seed(3e9);
Say("rand of much", rand(W))
Say("streams are numbered", W)
