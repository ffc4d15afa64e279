// A crab on wet sand at low sun: more than five hundred components in one blob, from the back shell to the teeth of
// its claws.
//   isl render scenes/gallery/crab_on_sand.isl
#version 3.7;
#include "creatures.isl"
global_settings { assumed_gamma 1 max_trace_level 3 }

camera { location <1.5, 1.35, -4.6> look_at <0.05, 0.3, -0.2> angle 38 }
sky_sphere {
  pigment { gradient y
    color_map { [0 rgb <1, 0.62, 0.38>] [0.12 rgb <0.9, 0.66, 0.55>] [0.4 rgb <0.5, 0.55, 0.68>]
      [1 rgb <0.2, 0.32, 0.55>] } }
}
light_source { <-9, 4.2, 3> rgb <1.5, 1.0, 0.62> area_light 1.5*y, 1.5*z, 5, 5 adaptive 1 circular orient }
light_source { <6, 8, -8> rgb <0.3, 0.36, 0.48> shadowless }

#declare Shell = texture {
  pigment {
    bozo turbulence 0.6 scale 0.25
    color_map { [0.25 rgb <0.42, 0.06, 0.03>] [0.6 rgb <0.62, 0.13, 0.05>] [0.8 rgb <0.7, 0.3, 0.12>] }
  }
  finish { ambient 0.06 diffuse 0.75 specular 0.6 roughness 0.015 reflection { 0.01, 0.2 falloff 4 } }
}
#macro Creature_paint(Part)
  #if (Part = "eye")
    texture { pigment { rgb 0.01 }
      finish { ambient 0 diffuse 0.3 specular 1 roughness 0.003 reflection { 0.03, 0.4 falloff 4 } } }
  #else
    #if (Part = "spine")
      texture { pigment { rgb <0.85, 0.55, 0.33> } finish { ambient 0.06 diffuse 0.75 specular 0.4 roughness 0.02 } }
    #else
      texture { Shell }
    #end
  #end
#end
blob {
  kernel "quartic" hardness 5
  Creature_crab(0.5*y, 1.25, 8, seed(5))
  rotate -24*y translate 0.1*x
}
// Wet sand: ripples that a thin film of water makes a mirror of, towards the light.
plane { y, 0
  pigment { bozo turbulence 0.7 scale <0.9, 1, 0.4>
    color_map { [0.3 rgb <0.32, 0.23, 0.15>] [0.7 rgb <0.45, 0.34, 0.24>] } }
  normal {
    average
    normal_map { [1 ripples 0.12 turbulence 0.5 scale 0.7 rotate 50*y translate 9*x] [1 granite 0.05 scale 0.15] }
  }
  finish { ambient 0.05 diffuse 0.55 specular 0.4 roughness 0.03 reflection { 0.04, 0.75 falloff 4 } }
}
fog { distance 60 rgb <0.85, 0.62, 0.48> }
