// A hive: wax between hexagonal cells that balls have carved, as bees press them, and honey that has begun to run.
//   isl render scenes/gallery/hive.isl
#version 3.7;
#include "random.isl"
global_settings { assumed_gamma 1 max_trace_level 3 }

camera { location <-1.7, 0.5, -5.2> look_at <0.02, -0.14, 0> angle 42 }
light_source { <-5, 6, -5> rgb <1.1, 0.95, 0.72> }
light_source { <3, 1.5, 5> rgb <1.5, 0.9, 0.3> }
light_source { <6, -1, -6> rgb <0.2, 0.2, 0.28> shadowless }
background { rgb <0.03, 0.014, 0.005> }
sky_sphere { pigment { gradient y
  color_map { [0 rgb <0.05, 0.02, 0.006>] [0.6 rgb <0.1, 0.05, 0.02>] [0.8 rgb <1.2, 1, 0.7>] } scale 2 translate -y } }

#declare Chance = Random_stream("bees", 3);
#declare Wax = texture {
  pigment { bozo scale 0.6 color_map { [0.2 rgb <0.72, 0.4, 0.07>] [0.8 rgb <0.9, 0.6, 0.17>] } }
  normal { bumps 0.12 scale 0.06 }
  finish { ambient 0.06 diffuse 0.7, 0.3 specular 0.35 roughness 0.03 }
}
#declare Honey = texture {
  pigment { rgb <0.62, 0.24, 0.015> }
  finish { ambient 0.05 diffuse 0.7, 0.3 specular 1 roughness 0.004 reflection { 0.02, 0.6 falloff 3 } }
}
#declare R = 0.25;
#macro Cell(I, J) <R*sqrt(3)*(I + 0.5*mod(abs(J), 2)), 1.5*R*J, 0> #end

// Each cell is six walls; neighbours share theirs, so only three are made.
blob {
  kernel "gaussian" hardness 2.5
  #for (J, -7, 7)
    #for (I, -6, 6)
      #local C = Cell(I, J);
      #if (vlength(C*<0.85, 1.05, 0>) < 1.75 + 0.2*rand(Chance))
        #for (K, 0, 5)
          #local A = C + R*vrotate(y, 60*K*z);
          #local B = C + R*vrotate(y, (60*K + 60)*z);
          #if (K < 3 | vlength(C) > 1.3)
            cylinder { A, B, 0.045 }
            cylinder { A + 0.09*z, B + 0.09*z, 0.04 }
            cylinder { A + 0.18*z, B + 0.18*z, 0.04 }
            cylinder { A + 0.27*z, B + 0.27*z, 0.04 }
          #end
        #end
      #end
    #end
  #end
  box { <-1.5, -1.3, 0.34>, <1.5, 1.3, 0.36>, 0.05 }
  texture { Wax }
}
// Honey in some cells, and three runs of it.
blob {
  kernel "gaussian" hardness 2
  #for (J, -4, 5)
    #for (I, -5, 5)
      #local C = Cell(I, J);
      #if (vlength(C - <0.3, 0.2, 0>) < 1.05 & rand(Chance) < 0.7)
        disc { C + 0.08*z, z, 0.12, 0.09 }
      #end
    #end
  #end
  #for (K, 0, 2)
    #local P = Cell(2 - 2*K, -1 + mod(K, 2)) + 0.02*z;
    #local L = 0.55 + 0.5*rand(Chance);
    sphere { P + 0.03*y, 0.19 }
    cone { P, 0.11, P - L*y - 0.05*z, 0.045 }
    sphere { P - (L + 0.08)*y - 0.06*z, 0.1 }
  #end
  texture { Honey }
}
