// Colours of pigments as functions: maps, lists, averages, POV-Ray's default maps; in single precision as there.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Say(Name, F)
  #debug concat(Name, "\n")
  #local S = seed(7);
  #for (I, 1, 20)
    #local X = 8*rand(S)-4; #local Y = 8*rand(S)-4; #local Z = 8*rand(S)-4;
    #local C = F(X,Y,Z);
    #debug concat(" ", str(C.red,0,12), " ", str(C.green,0,12), " ", str(C.blue,0,12), "\n")
    #debug concat(" ", str(C.filter,0,12), " ", str(C.transmit,0,12), " ", str(C.gray,0,12), "\n")
  #end
#end
Say("plain", function { pigment { rgb <0.1,0.2,0.3> } })
Say("all terms", function { pigment { rgbft <0.1,0.2,0.3,0.4,0.5> } })
#declare F = function { pigment {
  gradient x color_map { [0.1 rgbft 1] [1 rgbft <1/3,0.7,1/7,0.3,0.4>] }
} }
Say("two colours", F)
#undef F
#declare F = function { pigment {
  gradient x color_map { [0.1 rgb 1] [0.4 rgb <1/3,0.7,1/7>] [0.9 rgb
  <0.9,0.1,0.6>] }
} }
Say("three colours", F)
#undef F
#declare F = function { pigment {
  bozo color_map { [0.3 rgb 1] [0.3 rgb <1/3,0.7,1/7>] [0.6 rgb
  <0.9,0.1,0.6>] [0.6 rgb 0.3] }
} }
Say("steps", F)
#undef F
#declare F = function { pigment {
  gradient x pigment_map { [0.2 gradient y] [0.8 granite] }
} }
Say("pigment_map", F)
#undef F
#declare F = function { pigment {
  gradient x pigment_map { [0.2 gradient y scale 0.3] [0.8 granite
  color_map { [0 rgb 0.3] [1 rgb <1,0.2,0.7>] }] } scale 0.7 rotate 30
  turbulence 0.3
} }
Say("moved pigment_map", F)
#undef F
#declare F = function { pigment {
  average pigment_map { [1 gradient x] [2 granite] [0.3 rgb <1,0.5,0.2>] }
} }
Say("average", F)
#undef F
#declare F = function { pigment {
  average pigment_map { [gradient x] [granite] } scale 2
} }
Say("average without weights", F)
#undef F
Say("checker", function { pigment { checker rgb 0.3 rgb <0.2,0.9,0.1> } })
#declare F = function { pigment {
  checker pigment { bozo } pigment { granite }
} }
Say("checker of pigments", F)
#undef F
Say("hexagon", function { pigment { hexagon rgb 0.1 rgb 0.2 rgb 0.3 } })
Say("square", function { pigment { square rgb 0.1 rgb 0.2 rgb 0.3 rgb 0.4 } })
#declare F = function { pigment {
  triangular rgb 0.1 rgb 0.2 rgb 0.3 rgb 0.4 rgb 0.5 rgb 0.6
} }
Say("triangular", F)
#undef F
#declare F = function { pigment {
  cubic rgb 0.1 rgb 0.2 rgb 0.3 rgb 0.4 rgb 0.5 rgb 0.6
} }
Say("cubic", F)
#undef F
Say("brick", function { pigment { brick rgb 0.1 rgb 0.7 } })
Say("bozo", function { pigment { bozo } })
Say("marble", function { pigment { marble turbulence 0.4 } })
Say("wood", function { pigment { wood turbulence 0.1 } })
Say("agate", function { pigment { agate } })
Say("radial", function { pigment { radial } })
Say("mandel", function { pigment { mandel 20 } })
Say("checker default", function { pigment { checker } })
#declare F = function { pigment {
  average pigment_map { [1 average pigment_map { [1 rgb 0.1][3 rgb 0.9] }]
  [1 rgb 1/3] }
} }
Say("average of averages", F)
#undef F
#declare F = function { pigment {
  pigment_pattern { bozo } color_map { [0 rgb 0] [1 rgb <1,0.3,0.7>] }
} }
Say("pigment_pattern", F)
#undef F
Say("aoi", function { pigment { aoi color_map { [0 rgb 0.3] [1 rgb 0.7] } } })
#declare F = function { pigment {
  slope y color_map { [0 rgb 0.3] [1 rgb 0.7] }
} }
Say("slope", F)
#undef F
#declare P = function { pigment { granite color_map { [0 rgb 0.3] [1 rgb <1,0.2,0.7>] } } }
#declare Items = function { P(x,y,z).red + 10*P(x,y,z).green + 100*P(x,y,z).gray + 1000*P(x,y,z).hf }
#debug concat("items of a colour ", str(Items(0.1,0.2,0.3),0,12), "\n")
