// Prints which points lie within the shapes of shapesq.inc and logo.inc, and where screen.inc puts things.
// Both programs read this scene with their own files of these names and must print the same (tests/stdlib/compare.py).
#version 3.7;
global_settings { assumed_gamma 1 }
#include "shapes.inc"
#include "shapesq.inc"
#include "logo.inc"
#include "screen.inc"
#macro Inside(Text, Thing)
  #debug concat(Text, "\n")
  #local X = -3;
  #while (X <= 3)
    #local Y = -3;
    #while (Y <= 3)
      #local Z = -2;
      #while (Z <= 2)
        #debug str(inside(Thing, Scale*<X + 0.213, Y + 0.327, Z + 0.241> + Shift), 0, 0)
        #local Z = Z + 1;
      #end
      #local Y = Y + 1;
    #end
    #debug "\n"
    #local X = X + 1;
  #end
#end
#declare Scale = 0.31;
#declare Shift = <0, 0, 0>;
Inside("Bicorn", Bicorn)
Inside("Crossed_Trough", Crossed_Trough)
Inside("Cubic_Cylinder", Cubic_Cylinder)
Inside("Cubic_Saddle_1", Cubic_Saddle_1)
Inside("Devils_Curve", Devils_Curve)
Inside("Folium", Folium)
Inside("Glob_5", Glob_5)
Inside("Twin_Glob", Twin_Glob)
Inside("Helix", Helix)
Inside("Helix_1", Helix_1)
Inside("Lemniscate", Lemniscate)
Inside("Quartic_Loop_1", Quartic_Loop_1)
Inside("Monkey_Saddle", Monkey_Saddle)
Inside("Piriform", Piriform)
Inside("Quartic_Paraboloid", Quartic_Paraboloid)
Inside("Quartic_Cylinder", Quartic_Cylinder)
Inside("Steiner_Surface", Steiner_Surface)
Inside("Witch_Hat", Witch_Hat)
Inside("Sinsurf", Sinsurf)
#declare Scale = 2.9;
Inside("Hyperbolic_Torus_40_12", Hyperbolic_Torus_40_12)
Inside("Parabolic_Torus_40_12", Parabolic_Torus_40_12)
Inside("Torus_40_12", Torus_40_12)
#declare Scale = 0.23;
Inside("Povray_Logo", Povray_Logo)
Inside("Povray_Logo_Prism", Povray_Logo_Prism)
Inside("Povray_Logo_Bevel", Povray_Logo_Bevel)
#macro Show3(Text, V) #debug concat(Text, " ", vstr(3, V, " ", 0, 6), "\n") #end
#macro ShowCamera(Text)
  Show3(Text, CamL)
  Show3("right", CamR)
  Show3("up", CamU)
  Show3("ahead", CamD)
  #debug concat("zoom ", str(Camera_Zoom, 0, 6), "\n")
#end
ShowCamera("default")
Set_Camera_Location(<1, 2, -3>)
Set_Camera_Look_At(<0.5, 0, 1>)
Set_Camera_Sky(<0.2, 1, 0>)
Set_Camera_Aspect(16, 9)
ShowCamera("set")
Set_Camera_Aspect_Ratio(1.5)
Set_Camera_Angle(40)
ShowCamera("angle")
Set_Camera_Zoom(2)
ShowCamera("zoom")
Reset_Camera()
ShowCamera("reset")
// The two programs make pictures of different forms.
Set_Camera_Aspect(4, 3)
Set_Camera(<3, 1, -4>, <0, 1, 0>, 50)
ShowCamera("camera")
#declare Placed = object { Screen_Object(box { 0, <0.3, 0.1, 0.2> }, <1, 0.25>, <0.04, 0.02>, yes, 0.5) }
Show3("Screen_Object", min_extent(Placed))
Show3("to", max_extent(Placed))
#declare Placed = object { Screen_Object(box { -0.1, <0.2, 0.1, 0.3> }, <0.5, 0.5>, 0, no, 2) }
Show3("Screen_Object", min_extent(Placed))
Show3("to", max_extent(Placed))
#declare Placed = object { Screen_Plane(texture { pigment { rgb 1 } }, 0.1, <0.1, 0.5>, <0.5, 0.9>) }
Show3("Screen_Plane", min_extent(Placed))
Show3("to", max_extent(Placed))
