// All polyforms of `pavement`, with corners of all forms, at random points. POV-Ray knows the pattern in pigments alone.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare S = seed(11);
#macro Ask(F, Name)
  #debug concat(Name, "\n")
  #for (J, 1, 8)
    #local X = 40*rand(S)-20; #local Y = rand(S); #local Z = 40*rand(S)-20;
    #debug concat(" ", str(F(X,Y,Z).red,0,9), "\n")
  #end
#end
#macro Say(Sides, Tiles, Count)
  #for (I, 1, Count)
    #for (K, 0, 4)
      // 5 of the combinations for each polyform, others for the next.
      #local Outer = mod(K + I, 3); #local Inner = mod(int(K/2) + I, 3);
      #local Turn = mod(K + int(I/2), (Sides = 4 ? 4 : 3));
      #local F = function { pigment {
        pavement number_of_sides Sides number_of_tiles Tiles pattern I
        exterior Outer interior Inner form Turn
        color_map { [0 rgb 0] [1 rgb 1] }
      } }
      Ask(F, concat(str(Sides,0,0), " ", str(Tiles,0,0), " ", str(I,0,0), " ", str(Outer,0,0), " ", str(Inner,0,0), " ", str(Turn,0,0)))
      #undef F
    #end
  #end
#end
Say(3, 1, 1) Say(3, 2, 1) Say(3, 3, 1) Say(3, 4, 3) Say(3, 5, 4) Say(3, 6, 12)
Say(4, 1, 1) Say(4, 2, 1) Say(4, 3, 2) Say(4, 4, 5) Say(4, 5, 12) Say(4, 6, 35)
Say(6, 1, 1) Say(6, 2, 1) Say(6, 3, 3) Say(6, 4, 7) Say(6, 5, 22)
// Modifiers, and the map that a pigment has without one.
#declare F = function { pigment { pavement number_of_sides 4 number_of_tiles 3 pattern 2 turbulence 0.3 frequency 2 phase 0.25 scale 0.7 } }
Ask(F, "modifiers")
#undef F
#declare F = function { pigment { pavement } }
Ask(F, "defaults")
