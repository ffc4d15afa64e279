#version 3.7;
global_settings { assumed_gamma 1 }
#declare A = srgb <0.02, 0.5, 1>; #debug concat(vstr(5, A, " ", 0, 6), "\n")
#declare A = srgbt <0.2, 0.5, 1, 0.5>; #debug concat(vstr(5, A, " ", 0, 6), "\n")
