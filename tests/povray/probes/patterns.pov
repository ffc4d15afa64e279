// Values of patterns as functions: every family, at many points.
#version 3.7;
#macro SayDigits(Name, F, Digits)
  #debug concat(Name, "\n")
  #local S = seed(7);
  #for (I, 1, 30)
    #local X = 8*rand(S)-4; #local Y = 8*rand(S)-4; #local Z = 8*rand(S)-4;
    #debug concat(" ", str(F(X,Y,Z),0,Digits), "\n")
  #end
#end
#macro Say(Name, F) SayDigits(Name, F, 12) #end
Say("bozo", function { pattern { bozo } })
Say("agate", function { pattern { agate } })
#declare F = function { pattern {
  agate agate_turb 0.4 octaves 3 lambda 2.3 omega 0.4
} }
Say("agate agate_turb 0.4 octaves 3 lambda 2.3 omega 0.4", F)
#undef F
#declare F = function { pattern {
  agate turbulence <0.1,0.2,0.3>
} }
Say("agate turbulence <0.1,0.2,0.3>", F)
#undef F
Say("boxed", function { pattern { boxed } })
Say("boxed scale 5", function { pattern { boxed scale 5 } })
Say("bumps", function { pattern { bumps } })
Say("spotted", function { pattern { spotted } })
Say("brick", function { pattern { brick } })
#declare F = function { pattern {
  brick mortar 1.3 brick_size <2,1,1.5>
} }
Say("brick mortar 1.3 brick_size <2,1,1.5>", F)
#undef F
Say("cells", function { pattern { cells } })
Say("checker", function { pattern { checker } })
Say("crackle", function { pattern { crackle } })
Say("crackle form <1,0,0>", function { pattern { crackle form <1,0,0> } })
#declare F = function { pattern {
  crackle form <0.5,0.3,-0.4> offset 0.1
} }
Say("crackle form <0.5,0.3,-0.4> offset 0.1", F)
#undef F
Say("crackle metric 1", function { pattern { crackle metric 1 } })
#declare F = function { pattern {
  crackle metric 3.5 form <1,1,0>
} }
Say("crackle metric 3.5 form <1,1,0>", F)
#undef F
Say("crackle solid", function { pattern { crackle solid } })
Say("cubic", function { pattern { cubic } })
Say("cylindrical scale 4", function { pattern { cylindrical scale 4 } })
Say("dents", function { pattern { dents } })
Say("mandel 30", function { pattern { mandel 30 } })
Say("mandel 30 exponent 3", function { pattern { mandel 30 exponent 3 } })
#declare F = function { pattern {
  mandel 30 exponent 4 interior 1, 0.5
} }
Say("mandel 30 exponent 4 interior 1, 0.5", F)
#undef F
Say("mandel 20 exponent 7", function { pattern { mandel 20 exponent 7 } })
#declare F = function { pattern {
  julia <0.353,0.288>, 30
} }
Say("julia <0.353,0.288>, 30", F)
#undef F
#declare F = function { pattern {
  julia <0.353,0.288>, 30 exponent 5
} }
Say("julia <0.353,0.288>, 30 exponent 5", F)
#undef F
Say("magnet 1 mandel 30", function { pattern { magnet 1 mandel 30 } })
Say("magnet 2 mandel 30", function { pattern { magnet 2 mandel 30 } })
#declare F = function { pattern {
  magnet 1 julia <0.3,0.6>, 30
} }
Say("magnet 1 julia <0.3,0.6>, 30", F)
#undef F
#declare F = function { pattern {
  magnet 2 julia <0.3,0.6>, 30
} }
Say("magnet 2 julia <0.3,0.6>, 30", F)
#undef F
Say("gradient x", function { pattern { gradient x } })
Say("gradient <1,2,-3>", function { pattern { gradient <1,2,-3> } })
Say("gradient <0.1,0.2,0>", function { pattern { gradient <0.1,0.2,0> } })
Say("granite", function { pattern { granite } })
#declare F = function { pattern {
  granite noise_generator 1
} }
Say("granite noise_generator 1", F)
#undef F
#declare F = function { pattern {
  granite noise_generator 3
} }
Say("granite noise_generator 3", F)
#undef F
Say("hexagon", function { pattern { hexagon } })
Say("leopard", function { pattern { leopard } })
Say("marble", function { pattern { marble } })
Say("marble turbulence 0.7", function { pattern { marble turbulence 0.7 } })
#declare F = function { pattern {
  marble turbulence <0.5,2,3> octaves 4
} }
Say("marble turbulence <0.5,2,3> octaves 4", F)
#undef F
Say("onion", function { pattern { onion } })
Say("planar", function { pattern { planar } })
Say("quilted", function { pattern { quilted } })
#declare F = function { pattern {
  quilted control0 0.3 control1 0.8
} }
Say("quilted control0 0.3 control1 0.8", F)
#undef F
Say("radial", function { pattern { radial } })
Say("ripples", function { pattern { ripples } })
#declare F = function { pattern {
  ripples frequency 2 phase 0.3
} }
Say("ripples frequency 2 phase 0.3", F)
#undef F
Say("spherical scale 6", function { pattern { spherical scale 6 } })
Say("spiral1 3", function { pattern { spiral1 3 } })
#declare F = function { pattern {
  spiral1 -2 turbulence 0.4
} }
Say("spiral1 -2 turbulence 0.4", F)
#undef F
Say("spiral2 5", function { pattern { spiral2 5 } })
#declare F = function { pattern {
  spiral2 2 turbulence 0.4
} }
Say("spiral2 2 turbulence 0.4", F)
#undef F
Say("waves", function { pattern { waves } })
#declare F = function { pattern {
  waves frequency 0.3 phase 0.2
} }
Say("waves frequency 0.3 phase 0.2", F)
#undef F
Say("wood", function { pattern { wood } })
Say("wood turbulence 0.3", function { pattern { wood turbulence 0.3 } })
#declare F = function { pattern {
  wood turbulence <0.1,0.2,0.3> octaves 3
} }
Say("wood turbulence <0.1,0.2,0.3> octaves 3", F)
#undef F
Say("wrinkles", function { pattern { wrinkles } })
#declare F = function { pattern {
  wrinkles noise_generator 1
} }
Say("wrinkles noise_generator 1", F)
#undef F
#declare F = function { pattern {
  wrinkles noise_generator 3
} }
// Perlin's noise is computed far from the origin, which costs digits, and this asks for it 512 times as far.
SayDigits("wrinkles noise_generator 3", F, 11)
#undef F
Say("function { x*y+z }", function { pattern { function { x*y+z } } })
#declare F = function { pattern {
  pigment_pattern { gradient x color_map { [0 rgb <1,0.5,0.2>] [0.3 rgb
  0.1] [0.8 rgb <0,0.7,1>] } }
} }
Say("pigment_pattern", F)
#undef F
