// The scene that povray_picture_test.cpp builds in C++ and compares with what POV-Ray 3.7 makes of this file:
//   povray +Ipovray_solids.pov +W64 +H48 +FN16 -A -D File_Gamma=1.0
// Pixels at x = 4, 12, …, 60, y = 4, 12, …, 44 are the table in povray_pixels.h (16-bit, linear).
#version 3.7;
global_settings { assumed_gamma 1.0 ambient_light rgb <1, 0.9, 0.8> }
camera { location <0.5, 2, -6> direction <0, -0.25, 1> right <1.2, 0, 0> up <0, 0.9, 0.225> }
background { rgb <0.1, 0.2, 0.4> }
light_source { <-4, 6, -5> rgb <0.9, 0.8, 0.7> }
light_source { <5, 3, -3> rgb <0.2, 0.3, 0.4> shadowless }
plane { <0, 1, 0>, -1 pigment { rgb <0.7, 0.7, 0.6> } finish { ambient 0.15 diffuse 0.7 } }
sphere {
  <-1.2, 0, 0>, 1
  pigment { rgb <0.9, 0.3, 0.2> } finish { ambient 0.1 diffuse 0.6 phong 0.5 phong_size 25 }
}
cylinder {
  <0.6, -1, -0.5>, <1.1, 0.8, -0.2>, 0.45
  pigment { rgb <0.2, 0.6, 0.3> } finish { ambient 0.1 diffuse 0.7 specular 0.4 roughness 0.02 }
}
cone {
  <2.2, -1, 0.5>, 0.9, <2.2, 1, 0.5>, 0.2
  pigment { rgb <0.3, 0.4, 0.9> } finish { ambient rgb <0.2, 0.1, 0.1> diffuse 0.6 brilliance 2.5 phong 0.3 phong_size 90 specular 0.2 roughness 0.1 }
}
sphere {
  <0, 0, 0>, 1
  scale <1.5, 0.2, 0.6> rotate 30*z translate <0, 1.6, 1>
  pigment { rgb <0.8, 0.8, 0.1> } finish { ambient 0.1 diffuse 0.5 specular 0.8 roughness 0.005 }
}
cylinder {
  <-0.3, -0.6, -1.6>, <0.6, -0.5, -1.9>, 0.3 open
  pigment { rgb <0.6, 0.3, 0.6> } finish { ambient 0.1 diffuse 0.8 phong 0.4 phong_size 10 }
}
