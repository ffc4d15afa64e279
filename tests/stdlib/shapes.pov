// Prints which points lie within the shapes of shapes.inc and of the files of named shapes.
// Both programs read this scene with their own files of these names and must print the same (tests/stdlib/compare.py).
#version 3.7;
global_settings { assumed_gamma 1 }
#include "shapes.inc"
#include "shapes2.inc"
#include "chars.inc"
#macro Show(Text, V) #debug concat(Text, " ", str(V, 0, 6), "\n") #end
#macro Show3(Text, V) #debug concat(Text, " ", vstr(3, V, " ", 0, 6), "\n") #end
#macro Show5(Text, V) #debug concat(Text, " ", vstr(5, V, " ", 0, 6), "\n") #end
// POV-Ray takes points near flat polynomials for inside; such surfaces are left out.
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
#declare Thing = object { Center_Object(box { 0, <1, 2, 1> }, x + y) } Inside("Center_Object", Thing)
#declare Thing = object { Align_Object(box { 0, <1, 2, 1> }, <1, -1, 0>, 0.5) } Inside("Align_Object", Thing)
#declare Thing = object { Wedge(50) } Inside("Wedge", Thing)
#declare Thing = object { Wedge(180) } Inside("Wedge", Thing)
#declare Thing = object { Wedge(290) } Inside("Wedge", Thing)
#declare Thing = object { Spheroid(0.3*x, <1, 1.5, 0.6>) } Inside("Spheroid", Thing)
#declare Thing = object { Connect_Spheres(-x, 0.8, <1, 0.7, 0>, 0.3) } Inside("Connect_Spheres", Thing)
#declare Thing = object { Supercone(-y, 1, 1.5, <0, 1, 0.5>, 1, 0.4) } Inside("Supercone", Thing)
#declare Thing = object { Supercone(z, 1, 0.8, -z, 0.4, 1.1) } Inside("Supercone", Thing)
#declare Thing = object { Wire_Box(<-1, -1, -1>, <1, 0.6, 1.2>, 0.15, no) } Inside("Wire_Box", Thing)
#declare Thing = object { Wire_Box_Union(<-1, -1, -1>, <1, 0.6, -0.8>, 0.15) } Inside("Wire_Box_Union", Thing)
#declare Thing = object { Wire_Box_Merge(<-1, -1, -1>, <1, 0.6, 1.2>, 0.15) } Inside("Wire_Box_Merge", Thing)
#declare Thing = object { Round_Box(<-1, -1, -1>, <1, 0.6, 1.2>, 0.25, no) } Inside("Round_Box", Thing)
#declare Thing = object { Round_Box_Union(<1, 0.6, 1.2>, <-1, -1, -1>, 0.25) } Inside("Round_Box_Union", Thing)
#declare Thing = object { Round_Box_Merge(<-1, -1, -1>, <1, 0.6, -0.7>, 0.25) } Inside("Round_Box_Merge", Thing)
#declare Thing = object { Round_Cylinder(-y, <0.5, 1, 0>, 1, 0.3, no) } Inside("Round_Cylinder", Thing)
#declare Thing = object { Round_Cylinder_Union(-y, y, 0.6, 0.5) } Inside("Round_Cylinder_Union", Thing)
#declare Thing = object { Round_Cylinder_Merge(-x, z, 0.6, 0.1) } Inside("Round_Cylinder_Merge", Thing)
#declare Thing = object { Round_Cone(-y, 1.2, <0.3, 1, 0>, 0.7, 0.2, no) } Inside("Round_Cone", Thing)
#declare Thing = object { Round_Cone_Union(-x, 0.5, x, 0.9, 0.2) } Inside("Round_Cone_Union", Thing)
#declare Thing = object { Round_Cone_Merge(-y, 0.7, y, 0.7, 0.3) } Inside("Round_Cone_Merge", Thing)
#declare Thing = object { Round_Cone2(-y, 1, <0.5, 1, 0>, 0.5, no) } Inside("Round_Cone2", Thing)
#declare Thing = object { Round_Cone2_Union(-x, 0.4, x, 0.9) } Inside("Round_Cone2_Union", Thing)
#declare Thing = object { Round_Cone2_Merge(-y, 0.7, y, 0.3) } Inside("Round_Cone2_Merge", Thing)
#declare Thing = object { Round_Cone3(-y, 1, <0.5, 1, 0>, 0.5, no) } Inside("Round_Cone3", Thing)
#declare Thing = object { Round_Cone3_Union(-x, 0.4, x, 0.9) } Inside("Round_Cone3_Union", Thing)
#declare Thing = object { Round_Cone3_Merge(-y, 0.7, y, 0.3) } Inside("Round_Cone3_Merge", Thing)
Inside("Sphere", Sphere)
Inside("Ellipsoid", Ellipsoid)
Inside("Cube", Cube)
Inside("UnitBox", UnitBox)
Inside("Disk_X", Disk_X)
Inside("Disk_Y", Disk_Y)
Inside("Disk_Z", Disk_Z)
Inside("Cone_X", Cone_X)
Inside("Cone_Y", Cone_Y)
Inside("Cone_Z", Cone_Z)
Inside("Plane_XY", Plane_XY)
Inside("Plane_XZ", Plane_XZ)
Inside("Plane_YZ", Plane_YZ)
Inside("Cylinder_X", Cylinder_X)
Inside("Cylinder_Y", Cylinder_Y)
Inside("Cylinder_Z", Cylinder_Z)
Inside("QCone_X", QCone_X)
Inside("QCone_Y", QCone_Y)
Inside("QCone_Z", QCone_Z)
Inside("Paraboloid_X", Paraboloid_X)
Inside("Paraboloid_Y", Paraboloid_Y)
Inside("Paraboloid_Z", Paraboloid_Z)
Inside("Hyperboloid", Hyperboloid)
Inside("Hyperboloid_Y", Hyperboloid_Y)
Inside("Tetrahedron", Tetrahedron)
Inside("Octahedron", Octahedron)
Inside("Dodecahedron", Dodecahedron)
Inside("Icosahedron", Icosahedron)
Inside("HalfCone_Y", HalfCone_Y)
Inside("Hexagon", Hexagon)
Inside("Rhomboid", Rhomboid)
Inside("Pyramid2", Pyramid2)
#declare Scale = <0.7, 0.8, 0.3>;
#declare Shift = <0, 2.5, 0.5>;
Inside("char_A", char_A)
Inside("char_P", char_P)
Inside("char_B", char_B)
Inside("char_C", char_C)
Inside("char_D", char_D)
Inside("char_F", char_F)
Inside("char_E", char_E)
Inside("char_G", char_G)
Inside("char_H", char_H)
Inside("char_I", char_I)
Inside("char_J", char_J)
Inside("char_K", char_K)
Inside("char_L", char_L)
Inside("char_M", char_M)
Inside("char_N", char_N)
Inside("char_O", char_O)
Inside("char_Q", char_Q)
Inside("char_R", char_R)
Inside("char_S", char_S)
Inside("char_T", char_T)
Inside("char_U", char_U)
Inside("char_V", char_V)
Inside("char_W", char_W)
Inside("char_X", char_X)
Inside("char_Y", char_Y)
Inside("char_Z", char_Z)
Inside("char_0", char_0)
Inside("char_1", char_1)
Inside("char_2", char_2)
Inside("char_3", char_3)
Inside("char_4", char_4)
Inside("char_5", char_5)
Inside("char_6", char_6)
Inside("char_7", char_7)
Inside("char_8", char_8)
Inside("char_9", char_9)
Inside("char_Dash", char_Dash)
Inside("char_Plus", char_Plus)
Inside("char_ExclPt", char_ExclPt)
Inside("char_AtSign", char_AtSign)
Inside("char_Num", char_Num)
Inside("char_Dol", char_Dol)
Inside("char_Perc", char_Perc)
Inside("char_Hat", char_Hat)
Inside("char_Amps", char_Amps)
Inside("char_Astr", char_Astr)
Inside("char_LPar", char_LPar)
Inside("char_RPar", char_RPar)
Inside("char_LSqu", char_LSqu)
Inside("char_RSqu", char_RSqu)
#declare Place = <9, 9, 9>;
#declare Normal = <9, 9, 9>;
#declare Found = IsectN(<0.3, 0.2, -5>, z, Sphere, Place, Normal);
Show("Found", Found) Show3("Place", Place) Show3("Normal", Normal)
#declare Found = Isect(<0.3, 1.2, -5>, z, Sphere, Place);
Show("Found", Found) Show3("Place", Place)
#declare Found = Isect(<0.1, -0.2, -5>, z, Cube, Place);
Show("Found", Found) Show3("Place", Place)
