// A snow crystal: six arms that bear arms, thousands of balls melted into ice, in the light of a winter evening.
//   isl render scenes/gallery/snow_crystal.isl
#version 3.7;
#include "flakes.isl"
global_settings { assumed_gamma 1 max_trace_level 4 }

camera { location <0, 0, -5> look_at 0 angle 40 }
sky_sphere {
  pigment { gradient y
    color_map { [0 rgb <0.002, 0.004, 0.012>] [0.45 rgb <0.005, 0.012, 0.035>] [0.66 rgb <0.02, 0.05, 0.11>]
      [0.8 rgb <0.6, 0.75, 1>] [1 rgb <1, 0.9, 0.8>] } scale 2 translate -y }
}
light_source { <-5, 6, -5> rgb <1.1, 0.98, 0.9> }
light_source { <6, -3, -2> rgb <0.15, 0.3, 0.75> }
light_source { <2, 3, 6> rgb <0.5, 0.7, 1> }
blob {
  kernel "gaussian" hardness 2
  Flake_crystal(0, 1.25, -z, 3)
  #for (I, 0, 5)
    #local A = vrotate(0.3*x, (60*I + 30)*z);
    #local B = vrotate(0.3*x, (60*I + 90)*z);
    cylinder { A, B, 0.035 }
    cylinder { 0, 1.6*A, 0.03 }
  #end
  scale <1, 1, 0.7>
  rotate <0, 0, 15> rotate <26, -30, 0>
  pigment { rgb <0.72, 0.86, 1> }
  finish { ambient 0.03 diffuse 0.55, 0.3 specular 0.9 roughness 0.008 reflection { 0.06, 0.8 falloff 3 } }
}
