// A jellyfish in the deep: a bell that one ball carves out of another, arms and tentacles that wander, light from
// above.
//   isl render scenes/gallery/jellyfish.isl
#version 3.7;
#include "creatures.isl"
global_settings { assumed_gamma 1 max_trace_level 6 }

camera { location <0, 0.2, -9> look_at <0, -0.55, 0> angle 38 }
background { rgb <0.002, 0.012, 0.03> }
sky_sphere {
  pigment { gradient y
    color_map { [0 rgb <0.001, 0.004, 0.012>] [0.5 rgb <0.004, 0.025, 0.055>] [0.75 rgb <0.02, 0.12, 0.2>]
      [1 rgb <0.1, 0.4, 0.5>] } scale 2 translate -y }
}
light_source { <-3, 9, -2> rgb <0.7, 1, 1.1> }
light_source { <4, -2, 6> rgb <0.9, 0.35, 0.5> }

#declare Skin = texture {
  pigment { rgbt <0.75, 0.85, 1, 0.72> }
  finish { ambient 0.03 diffuse 0.55, 0.5 specular 0.6 roughness 0.01 }
}
#declare Flesh = texture {
  pigment { rgb <1, 0.5, 0.55> }
  finish { ambient 0.08 diffuse 0.6, 0.4 specular 0.4 roughness 0.02 }
}
#declare Chance = seed(12);
union {
  blob {
    kernel "gaussian" hardness 3
    sphere { 0, 1.28 scale <1, 0.92, 1> }
    sphere { 0, 1.1 strength -1.6 scale <1, 0.92, 1> translate -0.2*y }
    sphere { -1.6*y, 1.2 strength -3 }
    #for (I, 0, 23) sphere { vrotate(<1.21, -0.04, 0>, 15*I*y), 0.08 strength 0.7 } #end
    torus { 1.2, 0.06 translate 0.0*y }
    texture { Skin }
  }
  // The organs inside, and the frilled arms below them.
  blob {
    kernel "gaussian" hardness 3
    #for (I, 0, 3)
      torus { 0.22, 0.1 rotate 15*z translate 0.34*x + 0.42*y rotate (90*I + 30)*y }
      #local Arm = Creature_tentacle(<0.2, 0.3, 0>, <0.12, -1, 0>, 2.3, 0.17, 0.3, Chance);
      #local Even = Curve_resample(Arm, 60);
      #for (J, 0, 60)
        #local Q = Even[J];
        sphere { Curve_place(Q) + 0.75*(Q.t)*<cos(1.3*J), 0, sin(1.3*J)>, 0.75*Q.t rotate 90*I*y }
      #end
    #end
    texture { Flesh }
  }
  blob {
    kernel "quartic" hardness 3 convolution on
    #for (I, 0, 15)
      #local Foot = vrotate(<1.2, -0.02, 0>, (22.5*I + 11)*y);
      Curve_limb(Creature_tentacle(Foot, -y + 0.1*Foot, 2.6 + 1.2*rand(Chance), 0.04, 0.6, Chance), 28)
    #end
    texture { Skin }
  }
  rotate <-14, 0, -14>
}
