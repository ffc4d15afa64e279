// The scene that povray_picture_test.cpp builds in C++ and compares with what POV-Ray 3.7 makes of this file:
//   povray +Ipovray_blob.pov +W64 +H48 +FN16 -A -D File_Gamma=1.0
// Pixels at x = 4, 12, …, 60, y = 4, 12, …, 44 are the table in povray_pixels.h (16-bit, linear).
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.5, -5> direction <0, -0.25, 1> right <1.2, 0, 0> up <0, 0.9, 0.225> }
background { rgb <0.1, 0.2, 0.4> }
light_source { <-4, 6, -5> rgb <0.9, 0.8, 0.7> }
plane { <0, 1, 0>, -1 pigment { rgb <0.7, 0.7, 0.6> } finish { ambient 0.15 diffuse 0.7 } }
blob {
  threshold 0.6
  sphere { <-0.5, 0, 0>, 1.2, 1
    pigment { rgb <0.9, 0.1, 0.1> } finish { ambient 0.2 diffuse 0.8 phong 0.5 phong_size 5 } }
  sphere { <0.5, 0.2, 0>, 1.2, 1.5
    pigment { rgb <0.1, 0.2, 0.9> } finish { ambient 0.05 diffuse 0.3 brilliance 2 specular 0.5 roughness 0.1 } }
  cylinder { <-1.5, -0.8, 0.5>, <1.5, 1.2, -0.5>, 0.6, 1.2 pigment { rgb <0.2, 0.8, 0.3> } finish { ambient 0.1 diffuse 0.6 } }
  sphere { <0, 0, 0>, 1, -0.7 scale <0.5, 1, 0.7> translate <0, 0.8, -0.4> }
  pigment { rgb <0.9, 0.9, 0.2> } finish { ambient 0.1 diffuse 0.6 }
}
