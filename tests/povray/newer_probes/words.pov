// Words, constants, strings and what else 3.8 knows.
#version 3.8;
global_settings { assumed_gamma 1 }
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 6), "\n") #end
Say("version", version)
Say("tau", tau)
#declare Turn = function (x) { tau*x }
Say("tau in a function", Turn(0.5))
Say("rotate by tau", vrotate(x, degrees(tau/4)*z).y)
#version 3.7;
Say("version again", version)
Say("tau in an older scene", tau)
#declare D = dictionary { .a: 1 }
Say("a dictionary in an older scene", D.a)
#version 3.8;
#debug concat("escapes ", "a\\b", " ", "a\"b", "\n")
