// Prints results of every macro that needs no file.
// Both programs read this scene with their own files of these names and must print the same (tests/stdlib/compare.py).
#version 3.7;
global_settings { assumed_gamma 1 }
#include "strings.inc"
// In pieces, because POV-Ray breaks long lines.
#macro Say(Text)
  #local I = 1;
  #while (I <= strlen(Text))
    #debug concat("Piece ", substr(Text, I, min(40, strlen(Text) - I + 1)), "\n")
    #local I = I + 40;
  #end
#end
Say(Str(pi))
Say(VStr(<1, 2.5, -3>))
Say(VStr2D(<1, 2>))
Say(Vstr(<1, 2.5, -3>, 8, 2))
Say(Vstr2D(<1, 2>, 6, 3))
Say(CRGBStr(color rgb <0.25, 0.5, 0.75>, 0, 3))
Say(CRGBFTStr(color rgbft <0.25, 0.5, 0.75, 1, 0.125>, 6, 3))
Say(Triangle_Str(x, y, z))
Say(Smooth_Triangle_Str(x, -z, y, -z, x + y, <0, 1, -1>))
