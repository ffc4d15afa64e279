// Prints what macros of debug.inc, shapes.inc and textures.inc say or measure that no other scene here calls.
// Both programs read this scene with their own files of these names and must print the same (tests/stdlib/compare.py).
#version 3.7;
global_settings { assumed_gamma 1 }
#include "debug.inc"
#include "shapes.inc"
#include "textures.inc"
#macro Show3(Text, V) #debug concat(Text, " ", vstr(3, V, " ", 0, 6), "\n") #end
#macro ShowExtents(Text, Thing) Show3(Text, min_extent(Thing)) Show3("to", max_extent(Thing)) #end
Debug(yes, "Debug speaks\n")
Debug(no, "Debug is silent\n")
Set_Debug(no)
Debug_Message("nothing is said\n")
Set_Debug(yes)
Debug_Message("Debug_Message speaks\n")
Error(no, "no error")
Warning(no, "no warning")
Debug_Inc_Stack()
#declare Low = x;
#declare High = x;
Extents(box { <-1, 0, 2>, <3, 4, 5> }, Low, High)
Show3("Extents", Low)
Show3("to", High)
#declare Waves = function { 0.5 + 0.25*sin(9*x)*sin(7*y) }
#declare Thing = object { HF_Square(Waves, yes, no, <9, 9>, no, "", <-1, 0, -1>, <1, 0.5, 1>) }
#debug "HF_Square\n"
#declare Thing = object { HF_Cylinder(Waves, yes, no, <9, 9>, no, "", -y, y, 1, 0.2) }
#debug "HF_Cylinder\n"
#declare Thing = object { HF_Torus(Waves, yes, no, <9, 9>, yes, "", 1, 0.3, 0.1) }
#debug "HF_Torus\n"
#declare Thing = union { Smooth_Quad(0*x, y, x, y, x + z, x + y, z, y) }
ShowExtents("Smooth_Quad", Thing)
#debug concat("Text_Space ", str(Text_Space("cyrvetic.ttf", "Wall", 1, 0), 0, 6), "\n")
#declare Tiles = pigment { Hex_Tiles_Ptrn() color_map { [0 rgb 0] [1 rgb 1] } }
#debug "Hex_Tiles_Ptrn\n"
