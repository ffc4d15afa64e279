// Modifiers that move a pattern's point or shape its value: transforms, turbulence, warps, waves, frequency, phase.
#version 3.7;
#macro Say(Name, F)
  #debug concat(Name, "\n")
  #local S = seed(7);
  #for (I, 1, 30)
    #local X = 8*rand(S)-4; #local Y = 8*rand(S)-4; #local Z = 8*rand(S)-4;
    #debug concat(" ", str(F(X,Y,Z),0,12), "\n")
  #end
#end
#declare F = function { pattern {
  gradient x ramp_wave frequency 2.3 phase 0.2
} }
Say("ramp_wave frequency", F)
#undef F
#declare F = function { pattern {
  gradient x triangle_wave frequency -1.3
} }
Say("triangle_wave", F)
#undef F
Say("sine_wave", function { pattern { gradient x sine_wave phase 0.7 } })
#declare F = function { pattern {
  gradient x scallop_wave frequency 0.3
} }
Say("scallop_wave", F)
#undef F
Say("cubic_wave", function { pattern { gradient x cubic_wave phase -0.4 } })
Say("poly_wave", function { pattern { gradient x poly_wave 2.7 } })
Say("poly_wave bare", function { pattern { gradient x poly_wave } })
#declare F = function { pattern {
  marble frequency 0.4 phase 0.1
} }
Say("frequency of marble", F)
#undef F
#declare F = function { pattern {
  bozo frequency 0 phase 0.3 sine_wave
} }
Say("frequency 0", F)
#undef F
#declare F = function { pattern {
  cubic frequency 0.13 phase 0.2 triangle_wave
} }
Say("block frequency", F)
#undef F
#declare F = function { pattern {
  bozo rotate <10,20,30> scale <1,2,3> translate <0.3,0.2,0.1>
} }
Say("transforms", F)
#undef F
#declare F = function { pattern {
  bozo matrix <1,0.1,0.2,0.3,1,0,0,0.4,1,5,6,7>
} }
Say("matrix", F)
#undef F
#declare F = function { pattern {
  bozo scale 0.3 turbulence 0.5
} }
Say("scale then turbulence", F)
#undef F
#declare F = function { pattern {
  bozo turbulence 0.5 scale 0.3
} }
Say("turbulence then scale", F)
#undef F
#declare F = function { pattern {
  granite turbulence <0.1,0.5,0.3> octaves 3 lambda 2.7 omega 0.3
} }
Say("turbulence terms", F)
#undef F
#declare F = function { pattern {
  spotted turbulence 0.2 octaves 12
} }
Say("many octaves", F)
#undef F
Say("one octave", function { pattern { spotted turbulence 0.2 octaves 0 } })
#declare F = function { pattern {
  bozo warp { turbulence 0.4 } scale 2
} }
Say("warp turbulence", F)
#undef F
#declare F = function { pattern {
  gradient x scale 2 warp { turbulence 0.4 octaves 2 lambda 3 omega 0.7 }
  rotate 30*z
} }
Say("warps in order", F)
#undef F
#declare F = function { pattern {
  spherical turbulence 0.3 warp { turbulence <0,1,0> } scale 3
} }
Say("turbulence and warp", F)
#undef F
#declare F = function { pattern {
  marble warp { turbulence 0.4 } turbulence 0.5
} }
Say("marble and warp", F)
#undef F
#declare F = function { pattern {
  marble turbulence 0.5 noise_generator 3
} }
Say("noise generator of turbulence", F)
#undef F
#declare F = function { pattern {
  agate noise_generator 1
} }
Say("noise generator 1 of turbulence", F)
#undef F
Say("turbulent checker", function { pattern { checker turbulence 0.5 } })
Say("leopard scaled", function { pattern { leopard scale 0.2 } })
Say("density", function { pattern { spherical poly_wave 3 scale 4 } })
#declare F = function { pattern {
  bozo scale 0.7 warp { cylindrical  }
} }
Say("cylindrical ", F)
#undef F
#declare F = function { pattern {
  bozo scale 0.7 warp { cylindrical orientation y dist_exp 1 }
} }
Say("cylindrical orientation y dist_exp 1", F)
#undef F
#declare F = function { pattern {
  bozo scale 0.7 warp { cylindrical orientation <1,1,0> }
} }
Say("cylindrical orientation <1,1,0>", F)
#undef F
Say("spherical ", function { pattern { bozo scale 0.7 warp { spherical  } } })
#declare F = function { pattern {
  bozo scale 0.7 warp { spherical orientation x dist_exp 0.5 }
} }
Say("spherical orientation x dist_exp 0.5", F)
#undef F
#declare F = function { pattern {
  bozo scale 0.7 warp { spherical orientation <1,-2,3> }
} }
Say("spherical orientation <1,-2,3>", F)
#undef F
Say("toroidal ", function { pattern { bozo scale 0.7 warp { toroidal  } } })
#declare F = function { pattern {
  bozo scale 0.7 warp { toroidal orientation y dist_exp 1 major_radius 0.7
  }
} }
Say("toroidal orientation y dist_exp 1 major_radius 0.7", F)
#undef F
Say("planar ", function { pattern { bozo scale 0.7 warp { planar  } } })
#declare F = function { pattern {
  bozo scale 0.7 warp { planar <1,1,1> 0.5 }
} }
Say("planar <1,1,1> 0.5", F)
#undef F
#declare F = function { pattern {
  bozo scale 0.7 warp { planar -y, 0.2 }
} }
Say("planar -y, 0.2", F)
#undef F
Say("cubic ", function { pattern { bozo scale 0.7 warp { cubic  } } })
#declare F = function { pattern {
  bozo scale 0.7 warp { black_hole <0.1,0.2,0.3>, 3 }
} }
Say("black_hole <0.1,0.2,0.3>, 3", F)
#undef F
#declare F = function { pattern {
  bozo scale 0.7 warp { black_hole <0.1,0.2,0.3>, 3 strength 1.6 falloff
  1.2 }
} }
Say("black_hole <0.1,0.2,0.3>, 3 strength 1.6 falloff 1.2", F)
#undef F
#declare F = function { pattern {
  bozo scale 0.7 warp { black_hole <0.1,0.2,0.3>, 3 inverse strength 1.6
  falloff 1.2 }
} }
Say("black_hole <0.1,0.2,0.3>, 3 inverse strength 1.6 falloff 1.2", F)
#undef F
#declare F = function { pattern {
  bozo scale 0.7 warp { black_hole <0.1,0.2,0.3>, 0.6 repeat <1,1.3,0.9>
  falloff 1 }
} }
Say("black_hole <0.1,0.2,0.3>, 0.6 repeat <1,1.3,0.9> falloff 1", F)
#undef F
#declare F = function { pattern {
  bozo scale 0.7 warp { black_hole <0.1,0.2,0.3>, 0.6 repeat <1,1.3,0.9>
  turbulence <0.3,0.2,0.1> inverse }
} }
Say("black_hole <0.1,0.2,0.3>, 0.6 repeat <1,1.3,0.9> turbulence ", F)
#undef F
#declare F = function { pattern {
  bozo scale 0.7 warp { black_hole <0.1,0.2,0.3>, 0.6 repeat <1,0,0.7>
  falloff 1 }
} }
Say("black_hole <0.1,0.2,0.3>, 0.6 repeat <1,0,0.7> falloff 1", F)
#undef F
#declare F = function { pattern {
  bozo scale 0.7 warp { repeat 2.3*x }
} }
Say("repeat 2.3*x", F)
#undef F
#declare F = function { pattern {
  bozo scale 0.7 warp { repeat -1.7*y }
} }
Say("repeat -1.7*y", F)
#undef F
#declare F = function { pattern {
  bozo scale 0.7 warp { repeat 1.1*z offset <0.3,0.2,0.1> }
} }
Say("repeat 1.1*z offset <0.3,0.2,0.1>", F)
#undef F
#declare F = function { pattern {
  bozo scale 0.7 warp { repeat 1.1*x flip x }
} }
Say("repeat 1.1*x flip x", F)
#undef F
#declare F = function { pattern {
  bozo scale 0.7 warp { repeat 1.1*y offset <0.3,0.2,0.1> flip <1,1,0> }
} }
Say("repeat 1.1*y offset <0.3,0.2,0.1> flip <1,1,0>", F)
#undef F
#declare F = function { pattern {
  bozo scale 0.7 warp { repeat -1.1*y offset <0.3,0.2,0.1> flip <1,1,0> }
} }
Say("repeat -1.1*y offset <0.3,0.2,0.1> flip <1,1,0>", F)
#undef F
#declare F = function { pattern {
  bozo warp { spherical dist_exp 1 } scale 2 warp { repeat 2*x } rotate
  20*y warp { black_hole 0, 3 inverse }
} }
Say("two warps", F)
#undef F
