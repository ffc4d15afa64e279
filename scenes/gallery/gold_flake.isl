// A sphere-flake in gold: 7,381 balls melted into one piece of jewellery, lit by four soft boxes in a dark room.
//   isl render scenes/gallery/gold_flake.isl
#version 3.7;
#include "flakes.isl"
global_settings { assumed_gamma 1 max_trace_level 4 }

camera { location <0, 2.0, -6.2> look_at <0, 0.1, 0> angle 32 }
background { rgb <0.006, 0.006, 0.008> }

// What gold shows is what stands around it: panels of light, and a floor that is nearly black.
#macro Panel(Place, Width, Height, Colour)
  box { <-Width, -Height, 0>, <Width, Height, 0.01>
    pigment { rgb Colour } finish { ambient 1 diffuse 0 }
    no_shadow no_image
    #local Flat = vnormalize(Place*<1, 0, 1>);
    rotate degrees(atan2(Place.y, vlength(Place*<1, 0, 1>)))*x
    rotate degrees(atan2(Flat.x, Flat.z))*y
    translate Place
  }
#end
Panel(<-7, 5, -4>, 2.6, 3.5, <3.4, 3.1, 2.7>)
Panel(<1, -1, -9>, 6, 0.7, <0.5, 0.35, 0.22>)
Panel(<7.5, 3, 1>, 1.2, 4, <1.2, 1.5, 2.1>)
Panel(<1, 9, 1>, 5, 2.2, <1.8, 1.7, 1.6>)
light_source { <-7, 6, -5> rgb <1.1, 1, 0.85> }
light_source { <8, 4, 1> rgb <0.25, 0.3, 0.4> }

#declare Gold = array[5] { <1, 0.63, 0.2>, <1, 0.66, 0.24>, <1, 0.7, 0.3>, <1, 0.74, 0.36>, <1, 0.8, 0.45> }
#macro Flake_paint(Level)
  texture {
    pigment { rgb Gold[Level] }
    finish { ambient 0 diffuse 0.18 specular 0.7 roughness 0.02 metallic reflection { 0.72 metallic } }
  }
#end
blob {
  kernel "gaussian" hardness 4
  Flake_sphere(0, 0.72, y, 9, 1/3, 0.98, 4)
  rotate <-12, 20, 0>
}
plane { y, -1.02
  pigment { rgb <0.012, 0.012, 0.015> }
  finish { ambient 0 diffuse 0.6 reflection { 0.02, 0.5 falloff 3 } }
}
