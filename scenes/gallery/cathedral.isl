// The fractal cathedral: columns that fork into ribs until they are the vault. Branches of blobs carry one another as
// stone does in Gaudi's naves, without a single joint.
//   isl render scenes/gallery/cathedral.isl
#version 3.7;
#include "branching.isl"
global_settings { assumed_gamma 1 max_trace_level 3 }

camera { location <0, 1.3, -11> look_at <0, 4.4, 0> angle 76 }

// One column: a stem that forks in four, four times; all tips end in the vault.
#macro Rib(A, R, B, S)
  cone { A, R, B, S }
#end
#macro Grow(P, Spread, Rise, R, Level, Turn)
  #for (K, 0, 3)
    #local Q = P + vrotate(<Spread, Rise, 0>, (45 + 90*K + Turn)*y);
    Rib(P, R, Q, R*0.62)
    #if (Level < 3)
      Grow(Q, Spread*0.56, Rise*0.72, R*0.6, Level + 1, Turn + 12)
    #end
  #end
#end
#declare Column = blob {
  kernel "gaussian" hardness 3
  cone { <0, -0.5, 0>, 0.46, <0, 0.5, 0>, 0.3 }
  cone { <0, 0.3, 0>, 0.3, <0, 3.4, 0>, 0.24 }
  Grow(<0, 3.4, 0>, 1.0, 1.15, 0.18, 0, 0)
  pigment { rgb <0.82, 0.74, 0.64> }
  finish { ambient 0 diffuse 0.8 }
}
#for (I, 0, 6)
  #for (Side, -1, 1, 2)
    object { Column rotate 90*I*y translate <1.95*Side, 0, 3.9*I - 6> }
  #end
#end
plane { -y, -7.2 pigment { rgb <0.8, 0.72, 0.62> } finish { ambient 0 diffuse 0.8 } }
#for (Side, -1, 1, 2)
  plane { -Side*x, -5.2 pigment { rgb <0.7, 0.62, 0.54> } finish { ambient 0 diffuse 0.8 } }
#end
plane { y, 0
  pigment { rgb <0.35, 0.3, 0.27> }
  finish { ambient 0 diffuse 0.7 reflection { 0.03, 0.45 falloff 3 } }
}
// The window at the end, and the sun through it.
light_source { <0, 6, 21> rgb <1.5, 1.2, 0.85> fade_distance 14 fade_power 1 }
light_source { <0, 5, -12> rgb <0.5, 0.6, 0.85>*0.35 fade_distance 12 fade_power 1 }
#for (I, 0, 3)
  light_source { <0, 2.6, 6*I - 3> rgb <0.85, 0.5, 0.22> fade_distance 2.6 fade_power 2 }
#end
disc { <0, 4.2, 22>, -z, 2.1 pigment { rgb <1.6, 1.4, 1.0> } finish { ambient 1 diffuse 0 } no_shadow }
fog { distance 75 rgb <0.75, 0.55, 0.36> }
