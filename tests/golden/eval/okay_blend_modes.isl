// Modes of the working space change nothing; the others are told apart by probes of their colours.
#version 3.8;
global_settings { assumed_gamma 1 }
#declare Plain = pigment { gradient x color_map { blend_mode 0 [0 rgb 1] [1 rgb 0] } }
#declare Linear = pigment { gradient x color_map { blend_gamma 2 blend_mode 1 [0 rgb 1] [1 rgb 0] } }
#declare Same = pigment { gradient x color_map { blend_mode 2 [0.25 rgb 1] [0.25 rgb 0] } }
sphere { 0, 1 pigment { Plain } }
sphere { 0, 1 pigment { Linear } }
sphere { 0, 1 pigment { Same } }
