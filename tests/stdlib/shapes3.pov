// Prints which points lie within the shapes of shapes3.inc.
// Both programs read this scene with their own files of these names and must print the same (tests/stdlib/compare.py).
#version 3.7;
global_settings { assumed_gamma 1 }
#include "shapes3.inc"
// Whether the points of a grid of 7x7x5 lie within an object: digits, one word for each x.
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
#declare Scale = 0.43;
#declare Shift = <0, 0, 0>;
#declare Thing = object { Segment_of_Object(Round_Box(<-1, 0, -1>, <1, 1, 1>, 0.2, no), 70) } Inside("Segment_of_Object", Thing)
#declare Thing = object { Segment_of_Object(torus { 1, 0.4 }, -250) } Inside("Segment_of_Object", Thing)
#declare Thing = object { Segment_of_CylinderRing(1.4, 0.9, 0.7, 100) } Inside("Segment_of_CylinderRing", Thing)
#declare Thing = object { Segment_of_CylinderRing(0.9, 1.4, 0.7, -230) } Inside("Segment_of_CylinderRing", Thing)
#declare Thing = object { Segment_of_CylinderRing(1.4, 0.9, -0.7, 0) } Inside("Segment_of_CylinderRing", Thing)
#declare Thing = object { Segment_of_Torus(1.2, 0.4, 130) } Inside("Segment_of_Torus", Thing)
#declare Thing = object { Segment_of_Torus(1.2, 0.4, -220) } Inside("Segment_of_Torus", Thing)
#declare Thing = object { Segment_of_Torus(1.2, 0.4, 360) } Inside("Segment_of_Torus", Thing)
#declare Thing = object { Round_N_Tube_Polygon(5, 0.2, 1.2, 0.4, 0, 0) } Inside("Round_N_Tube_Polygon", Thing)
#declare Thing = object { Round_N_Tube_Polygon(3, 0.25, 0.9, 0.3, 0.5, 1) } Inside("Round_N_Tube_Polygon", Thing)
#declare Thing = object { Round_N_Tube_Polygon(6, 0.2, 1.2, 1.2, 1, 0) } Inside("Round_N_Tube_Polygon", Thing)
#declare Thing = object { Pyramid_N(5, 1.3, 0.6, 1.5) } Inside("Pyramid_N", Thing)
#declare Thing = object { Pyramid_N(3, 1, 0, 1.6) } Inside("Pyramid_N", Thing)
#declare Thing = object { Pyramid_N_AB(6, <-1, 0, 0>, 1, <1, 1, 0.5>, 0.4) } Inside("Pyramid_N_AB", Thing)
#declare Thing = object { Column_N(7, 1, 1.2) } Inside("Column_N", Thing)
#declare Thing = object { Column_N_AB(4, <-1, -0.5, 0>, <1, 0.7, 0>, 0.6) } Inside("Column_N_AB", Thing)
#declare Thing = object { Egg_Shape(1.1, 1.7) } Inside("Egg_Shape", Thing)
#declare Thing = object { Facetted_Sphere(4, 9) } Inside("Facetted_Sphere", Thing)
#declare Thing = object { Facetted_Egg_Shape(3, 8, 0.8, 1.4) } Inside("Facetted_Egg_Shape", Thing)
#declare Thing = object { Facetted_Egg(5, 12) } Inside("Facetted_Egg", Thing)
#declare Thing = object { Ring_Sphere(1.4, 1.45, 0.07, 0.05, 5, 7) } Inside("Ring_Sphere", Thing)
#declare Thing = object { Round_Pyramid_N_out(5, -y, 1.4, y, 0.8, 0.2, 1, 0) } Inside("Round_Pyramid_N_out", Thing)
#declare Thing = object { Round_Pyramid_N_out(4, -x, 0.6, <1, 0.5, 0>, 1.3, 0.15, 0, 0) } Inside("Round_Pyramid_N_out", Thing)
#declare Thing = object { Round_Pyramid_N_out(3, -y, 1.4, y, 0.2, 0.2, 1, 1) } Inside("Round_Pyramid_N_out", Thing)
#declare Thing = object { Round_Pyramid_N_in(6, -y, 1.2, y, 0.5, 0.25, 1, 0) } Inside("Round_Pyramid_N_in", Thing)
#declare Thing = object { Rounded_Tube(1.4, 0.9, 0.15, 0.8, 0) } Inside("Rounded_Tube", Thing)
#declare Thing = object { Rounded_Tube_AB(<-1, 0, 0>, <1, 0.4, 0>, 1, 0.6, 0.2, 1) } Inside("Rounded_Tube_AB", Thing)
#declare Thing = object { Round_Cylinder_Tube(-y, <0.3, 1, 0>, 1, 0.2, 0, 0) } Inside("Round_Cylinder_Tube", Thing)
#declare Thing = object { Round_Cylinder_Tube(-x, x, 0.8, 0.3, 1, 1) } Inside("Round_Cylinder_Tube", Thing)
#declare Thing = object { Round_Conic_Torus(1.5, 0.5, 1, 0.15, 0) } Inside("Round_Conic_Torus", Thing)
#declare Thing = object { Round_Conic_Torus(1.2, 1, 0.4, 0.2, 1) } Inside("Round_Conic_Torus", Thing)
#declare Thing = object { Round_Conic_Prism(1.4, 0.5, 1, 0.9, 0.15, 0) } Inside("Round_Conic_Prism", Thing)
#declare Thing = object { Round_Conic_Prism(1.2, 1, 0.4, 1.2, 0, 1) } Inside("Round_Conic_Prism", Thing)
#declare Thing = object { Half_Hollowed_Rounded_Cylinder1(3, 0.8, 0.3, 0.8, 0) } Inside("Half_Hollowed_Rounded_Cylinder1", Thing)
#declare Thing = object { Half_Hollowed_Rounded_Cylinder1(2.6, 1, 0.25, 0, 1) } Inside("Half_Hollowed_Rounded_Cylinder1", Thing)
#declare Thing = object { Half_Hollowed_Rounded_Cylinder2(3, 1, 0.5, 0.1, 1, 0) } Inside("Half_Hollowed_Rounded_Cylinder2", Thing)
#declare Thing = object { Half_Hollowed_Rounded_Cylinder2(3, 0.9, 0.4, 0.15, 0, 1) } Inside("Half_Hollowed_Rounded_Cylinder2", Thing)
Inside("Egg", Egg)
