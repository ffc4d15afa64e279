// Dot items of every kind of value, and vectors of two to five terms.
#version 3.7;
#macro Say(Name, X) #debug concat(Name, " ", str(X, 0, 6), "\n") #end
#macro Say5(Name, V) #debug concat(Name, " ", vstr(5, V, " ", 0, 3), "\n") #end
#declare P = <1, 2>; #declare Q = <1, 2, 3>; #declare R = <1, 2, 3, 4>; #declare S = <1, 2, 3, 4, 5>;
Say("u", P.u) Say("v", P.v) Say("z", Q.z) Say("t", R.t) Say("transmit", S.transmit) Say("filter", S.filter)
Say("red", Q.red) Say("green", Q.green) Say("blue", Q.blue) Say("gray", Q.gray)
Say("of a literal", <4, 5, 6>.y)
Say("of a constant", z.z)
Say("of a sum", (Q + x).x)
Say("of a negative", -Q.y)
Say("of a function", vcross(x, y).z)
Say("of a product", (2*Q).z + 2*Q.z)
#declare A = array[2] { <1, 2, 3>, <4, 5, 6> }
Say("of an element", A[Q.x].y)
#declare F = function { pigment { rgb <0.25, 0.5, 0.75> } }
Say("of a pigment", F(0, 0, 0).green)
Say5("two and three", P + Q)
Say5("three and four", Q*R)
Say5("four and five", R - S)
Say5("a number and five", 1/S)
Say5("u and v", u + 2*v)
#declare T = x + t; Say5("x and t", T)
Say5("unary", -(+S))
Say5("not", !P)
Say5("divided", S/<2, 4, 5>)
Say("length of two", vlength(P))
Say("dot of different lengths", vdot(P, Q))
#declare V = <1 2 3>; Say5("no commas", V)
#declare V = <1 -2 3>; Say5("a minus goes on", V)
#declare V = <-1, +2, -(-3)>; Say5("signs", V)
#declare V = <Q.x, Q.y*2, vlength(Q - <0, 2, 3>)>; Say5("expressions", V)
#declare V = <1, 2, 3>*<1, 2>; Say5("a shorter one", V)
