// A trefoil knot of porcelain whose thread swells and thins, glazed in blue where it is thin; convolution keeps it
// even where it turns.
//   isl render scenes/gallery/knot.isl
#version 3.7;
#include "curves.isl"
global_settings { assumed_gamma 1 max_trace_level 2 }

camera { location <0, 4.2, -9> look_at <0, 1.35, 0> angle 33 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.42, 0.4, 0.4>] [1 rgb <0.75, 0.8, 0.95>] } } }
light_source { <-6, 8, -3> rgb <1.1, 0.98, 0.82> area_light 3*x, 3*z, 8, 8 jitter circular orient }
light_source { <7, 4, -8> rgb <0.22, 0.26, 0.34> shadowless }

#declare Knot = Curve_knot(2, 3, 1.15, 0.52, 0.24);
#declare N = dimension_size(Knot, 1) - 1;
#for (I, 0, N)
  #declare Knot[I] = Knot[I] + 0.07*sin(6*pi*I/N*3)*t;
#end
#macro Curve_paint(Share)
  #local Glaze = pow(0.5 - 0.5*sin(18*pi*Share), 2);
  texture {
    pigment { rgb <0.93, 0.92, 0.88> + (<0.05, 0.12, 0.36> - <0.93, 0.92, 0.88>)*Glaze }
    finish { ambient 0.1 diffuse 0.75 specular 0.6 roughness 0.005 reflection { 0.02, 0.4 falloff 4 } }
  }
#end
blob {
  kernel "quartic" hardness 3 convolution on
  Curve_limb(Knot, 72)
  rotate <-62, 20, 0> translate 1.7*y
}
plane { y, 0 pigment { rgb <0.55, 0.5, 0.46> } finish { ambient 0.1 diffuse 0.7 } }
