// All tilings at random points, near the origin and far from it. POV-Ray knows the pattern in pigments alone.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare S = seed(13);
#macro Ask(F, Count, Size)
  #for (J, 1, Count)
    #local X = Size*(rand(S)-0.5); #local Y = rand(S); #local Z = Size*(rand(S)-0.5);
    #debug concat(" ", str(F(X,Y,Z).red,0,9), "\n")
  #end
#end
#for (I, 1, 27)
  #debug concat("tiling ", str(I,0,0), "\n")
  #declare F = function { pigment { tiling I color_map { [0 rgb 0] [1 rgb 1] } } }
  Ask(F, 150, 12)
  Ask(F, 50, 2000)
  #undef F
#end
#declare F = function { pigment { tiling 9 turbulence 0.3 frequency 2 phase 0.25 scale 0.7 } }
Ask(F, 40, 8)
