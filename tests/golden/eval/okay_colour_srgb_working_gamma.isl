// srgb is decoded into the working space that assumed_gamma names. POV-Ray 3.7 prints the same.
#version 3.7;
global_settings { assumed_gamma 2.2 }
#declare A = srgb .5; #debug concat(vstr(5, A, " ", 0, 6), "\n")
#declare A = srgbft .5; #debug concat(vstr(5, A, " ", 0, 6), "\n")
#declare A = srgb <0.03, 0.5, 1>; #debug concat(vstr(5, A, " ", 0, 4), "\n")
