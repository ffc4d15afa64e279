// The patterns and images of 3.8.
#version 3.8;
global_settings { assumed_gamma 1 }
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 4), "\n") #end
#macro SayColour(Name, C) #local V = C; #debug concat(Name, " ", vstr(5, V, " ", 0, 4), "\n") #end

// `potential`: the field of a blob.
#declare Two = blob { threshold 0.5 sphere { 0, 2, 1 } cylinder { x, 3*x, 1, -0.5 } }
#declare Field = function { pattern { potential { Two } } }
#declare Less = function { pattern { potential { Two } threshold on } }
#declare Not_less = function { pattern { potential { Two } threshold off } }
#declare Moved = function { pattern { potential { object { Two scale 2 translate y } } threshold on } }
#declare Opposite = function { pattern { potential { object { Two inverse } } } }
#declare Strong = function { pattern { potential { blob { threshold 1 sphere { 0, 1, 5 } } } } }
#declare Ramp = function { pattern { potential { blob { threshold 1 sphere { 0, 1, 5 } } } ramp_wave frequency 2 } }
#declare Frequency = function { pattern { potential { Two } frequency 3 phase 0.2 scale 2 } }
Say("field", Field(0.5, 0.3, 0.2))
Say("below 0", Field(2.5, 0.1, 0.3))
Say("beyond", Field(5, 0, 0))
Say("less the threshold", Less(0.5, 0.3, 0.2))
Say("threshold off", Not_less(0.5, 0.3, 0.2))
Say("moved", Moved(0.5, 1.3, 0.2))
Say("inverse", Opposite(0.5, 0.3, 0.2))
Say("above 1", Strong(0.1, 0, 0))
Say("in a wave", Ramp(0.1, 0, 0))
Say("frequency without a wave", Frequency(0.5, 0.3, 0.2))

// `user_defined`: a colour by functions.
#declare F1 = function (x, y, z) { x + 2*y }
#declare All_five = function { pigment { user_defined { function { x } function { F1(x, y, z) } function { z*z } function { 0.25 } function { y } } } }
#declare Some = function { pigment { user_defined { , function { x }, , , function { 0.5 } } } }
#declare Two_only = function { pigment { user_defined { function { x }, function { y } } scale 2 } }
#declare None = function { pigment { user_defined { } } }
#declare Turbulent = function { pigment { user_defined { function { x } } translate x rotate 90*z } }
SayColour("five terms", All_five(0.1, 0.2, 0.3))
SayColour("terms left out", Some(0.1, 0.2, 0.3))
SayColour("terms at the end left out", Two_only(0.1, 0.2, 0.3))
SayColour("no terms", None(0.1, 0.2, 0.3))
SayColour("moved", Turbulent(0.1, 0.2, 0.3))

// An angular map.
#declare Angular = function { pigment { image_map { function 64, 64 { x + 10*y } map_type 7 } } }
Say("ahead", Angular(0, 0, 1).red)
Say("to the right", Angular(1, 0, 0).red)
Say("up", Angular(0, 2, 0).red)
Say("aslant", Angular(0.3, -0.5, 0.4).red)
Say("nearly behind", Angular(0.01, 0.02, -1).red)
Say("behind", Angular(0, 0, -1).red)
