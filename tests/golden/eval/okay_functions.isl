// Functions: what is captured when, what they may call, and what they yield.
#macro Say(V) #debug concat(str(V, 0, 9), "\n") #end
#declare K = 3;
#declare Scaled = function(a) { K*a }
#declare K = 5;
Say(Scaled(2))
#declare Wave = function { sin(x)*y + select(z, -1, 0, 1) | 0 & 0 }
Say(Wave(1, 2, 3))
#declare Both = function(a, b) { Scaled(a) - Scaled(b)/2 }
Say(Both(1 2))
#declare Series = function(a) { sum(i, 1, a, prod(j, 1, i, a/j)) }
Say(Series(4))
#declare Looped = function(a) { 0 #for (I, 1, 3) + I*pow(a, I) #end }
Say(Looped(2))
#declare Moved = function { transform { scale 2 translate <1,2,3> } }
#debug concat(vstr(3, Moved(1, 1, 1), ",", 0, 3), "\n")
#declare Tint = function { pigment { rgb <1,0.5,0.25> } }
#declare Grey = function { Tint(x, y, z).gray + Moved(x, y, z).y }
Say(Grey(0, 0, 0))
#declare Heart = function { internal(23) }
Say(Heart(0.1, 0.2, 0.3, 1))
#macro Apply(F, V) F(V) #end
Say(Apply(function(a) { a*a }, 3))
#declare F2 = array[2] { Scaled, function(a) { -a } }
Say(F2[0](1) + F2[1](1))
