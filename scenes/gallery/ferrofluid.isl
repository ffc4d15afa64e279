// Ferrofluid over a magnet: spikes stand where the field is strong, and the liquid between them is a mirror. Heights
// follow the distance from the middle, places the golden angle.
//   isl render scenes/gallery/ferrofluid.isl
#version 3.7;
#include "growth.isl"
global_settings { assumed_gamma 1 max_trace_level 6 }

camera { location <0, 3.3, -6.6> look_at <0, 0.1, 0> angle 33 }
sky_sphere {
  pigment { gradient y
    color_map { [0 rgb 0.85] [0.2 rgb 0.75] [0.45 rgb 0.1] [0.7 rgb 0.08] [0.75 rgb 1.3] [1 rgb 1.3] } }
}
light_source { <-5, 7, 4> rgb 1.2 area_light 2*x, 2*z, 5, 5 adaptive 0 circular orient }
light_source { <6, 4, -2> rgb <0.3, 0.4, 0.6> }

blob {
  kernel "gaussian" hardness 3
  disc { -0.14*y, y, 1.5, 0.12 }
  kernel "cubic" hardness 3
  #declare Count = 75;
  #for (I, 0, Count - 1)
    #local P = 1.28*Growth_disc(I, Count);
    #local R = vlength(P);
    #local H = 0.12 + 0.5*pow(1 - R*R/2.1, 1.2);
    // The field lines lean outwards.
    #local Top = P*(1 + 0.22*R) + H*y;
    cone { P - 0.04*y, 0.15, Top, 0.008 }
  #end
  pigment { rgb 0.012 }
  finish { ambient 0 diffuse 0.3 specular 0.9 roughness 0.003 reflection { 0.16, 0.9 falloff 3 } }
}
plane { y, -0.2 pigment { rgb 0.86 } finish { ambient 0.4 diffuse 0.5 } }
