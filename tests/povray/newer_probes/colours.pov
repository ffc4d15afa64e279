// Colours of maps with blend modes.
#version 3.8;
global_settings { assumed_gamma 1 }
#macro Colour(Name, C) #debug concat(Name, " ", vstr(3, C, " ", 0, 4), "\n") #end
#declare Mode_0 = function { pigment { gradient x color_map { blend_mode 0 [0 rgb <1, 0.2, 0.1>] [1 rgb <0.1, 0.6, 0>] } } }
#declare Mode_1 = function { pigment { gradient x color_map { blend_mode 1 [0 rgb <1, 0.2, 0.1>] [1 rgb <0.1, 0.6, 0>] } } }
#declare Mode_2 = function { pigment { gradient x color_map { blend_mode 2 [0 rgb <1, 0.2, 0.1>] [1 rgb <0.1, 0.6, 0>] } } }
#declare Mode_3 = function { pigment { gradient x color_map { blend_mode 3 [0 rgb <1, 0.2, 0.1>] [1 rgb <0.1, 0.6, 0>] } } }
#declare Strong = function { pigment { gradient x color_map { blend_mode 2 blend_gamma 1.5 [0 rgb 2] [1 rgb 0.5] } } }
#declare Map = color_map { blend_mode 2 [0 rgb 1] [1 rgb 0] }
#declare Named = function { pigment { gradient x color_map { Map } } }
#declare Pigments = function { pigment { gradient x pigment_map { blend_mode 2 [0 rgb <1, 0, 0>] [1 rgb 0] } } }
Colour("working space", Mode_0(0.25, 0, 0))
Colour("linear", Mode_1(0.25, 0, 0))
Colour("gamma", Mode_2(0.25, 0, 0))
Colour("gamma, half", Mode_2(0.5, 0, 0))
Colour("brightness", Mode_3(0.25, 0, 0))
Colour("brightness, half", Mode_3(0.5, 0, 0))
Colour("another gamma", Strong(0.5, 0, 0))
Colour("declared", Named(0.5, 0, 0))
Colour("pigments", Pigments(0.25, 0, 0))
