// A lava lamp: warm wax that parts and joins in a glass, the lamp below it the only light.
//   isl render scenes/gallery/lava_lamp.isl
#version 3.7;
#include "random.isl"
global_settings { assumed_gamma 1 max_trace_level 8 }

camera { location <0, 2.9, -13> look_at <0, 2.12, 0> angle 45 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.07, 0.025, 0.045>] [0.35 rgb <0.012, 0.006, 0.02>] } } }
light_source { <0, 0.62, 0> rgb <1.6, 0.75, 0.4> fade_distance 2.2 fade_power 1.4 }
light_source { <-6, 5, -6> rgb <0.2, 0.18, 0.26> shadowless }
light_source { <6, 4, -4> rgb <0.12, 0.08, 0.16> shadowless }

#declare Chance = Random_stream("wax", 9);
// Wax: it glows by itself, more the nearer it is to the lamp.
blob {
  kernel "gaussian" hardness 1.7
  disc { 0.72*y, y, 0.62, 0.16 }
  sphere { <0.1, 1.2, 0>, 0.34 }
  sphere { <0.04, 1.75, 0>, 0.26 }
  sphere { <-0.16, 2.35, 0.05>, 0.36 }
  sphere { <0.22, 2.92, -0.1>, 0.2 }
  sphere { <0.2, 3.5, 0.1>, 0.3 }
  sphere { <-0.05, 3.86, 0>, 0.24 }
  sphere { <-0.3, 1.5, -0.25>, 0.13 }
  sphere { <0.34, 2.12, -0.2>, 0.11 }
  sphere { <-0.26, 3.1, -0.1>, 0.1 }
  disc { 4.72*y, y, 0.22, 0.12 }
  pigment {
    gradient y scale 5
    color_map { [0.12 rgb <1, 0.62, 0.14>] [0.4 rgb <1, 0.25, 0.06>] [1 rgb <0.75, 0.05, 0.1>] }
  }
  finish { emission 0.42 diffuse 0.6 specular 0.4 roughness 0.02 }
}
// The glass, a cone that narrows upwards, and its metal foot and cap.
#declare Glass = texture {
  pigment { rgbf <0.98, 0.8, 0.85, 0.96> }
  finish { ambient 0 diffuse 0.03 specular 0.9 roughness 0.002 reflection { 0.01, 0.6 falloff 5 } }
}
cone { 0.4*y, 0.96, 4.9*y, 0.46 open texture { Glass } }
#declare Metal = texture {
  pigment { rgb <0.55, 0.5, 0.5> }
  finish { ambient 0 diffuse 0.25 specular 0.6 roughness 0.03 metallic reflection { 0.35 metallic } }
}
blob {
  kernel "cubic" hardness 6
  cone { -0.95*y, 0.98, -0.1*y, 0.62 }
  cone { 0.05*y, 0.62, 0.42*y, 0.92 }
  texture { Metal }
}
intersection {
  blob { kernel "cubic" hardness 6 cone { 4.9*y, 0.47, 5.45*y, 0.3 } }
  plane { -y, -4.88 }
  texture { Metal }
}
light_source { <0, 2.6, 0> rgb <1.1, 0.4, 0.22> shadowless fade_distance 1.6 fade_power 1.6 }
plane { -z, -2.6 pigment { rgb <0.42, 0.36, 0.4> } finish { ambient 0.01 diffuse 0.7 } }
plane { y, -1.4
  pigment { rgb <0.2, 0.13, 0.1> }
  finish { ambient 0.02 diffuse 0.6 reflection { 0.03, 0.5 falloff 3 } }
}
