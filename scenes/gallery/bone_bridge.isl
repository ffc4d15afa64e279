// A bridge of bones: an arch of limbs that swell at their joints, ribs that carry the way, over a valley of fog.
// Nothing is built, everything is grown together.
//   isl render scenes/gallery/bone_bridge.isl
#version 3.7;
#include "curves.isl"
global_settings { assumed_gamma 1 }

camera { location <-9, 3.2, -27> look_at <-1.2, 0.2, 0> angle 50 }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.82, 0.76, 0.68>] [0.2 rgb <0.5, 0.57, 0.64>] [0.6 rgb <0.2, 0.29, 0.4>] } }
}
light_source { <-30, 26, -6> rgb <1.3, 1.08, 0.8> }
light_source { <20, 10, -30> rgb <0.16, 0.2, 0.28> shadowless }

// Thick at both ends, thin between them.
#macro Bone(A, B, R)
  cone { A, R*1.3, A + 0.3*(B - A), R*0.62 }
  cylinder { A + 0.3*(B - A), A + 0.7*(B - A), R*0.62 }
  cone { A + 0.7*(B - A), R*0.62, B, R*1.3 }
#end
#macro Arch(T, Z) <9*T, 3.6*(1 - T*T) - 2.2, Z*(1 + 0.5*T*T)> #end
#macro Deck(T, Z) <11*T, 2.3 - 0.8*T*T, Z> #end
#declare Parts = 12;
blob {
  kernel "gaussian" hardness 3
  #for (Z, -1, 1, 2)
    #for (I, -Parts/2, Parts/2 - 1)
      #local T = 2*I/Parts;
      #local Next = 2*(I + 1)/Parts;
      Bone(Arch(T, Z), Arch(Next, Z), 0.34)
      Bone(Deck(T, 0.9*Z), Deck(Next, 0.9*Z), 0.2)
      Bone(Arch(T, Z), Deck(T, 0.9*Z), 0.2)
      // Each rib of the rail curves inwards.
      #local P = Deck((T + 1/Parts), 0.9*Z);
      cone { P, 0.13, P + <0, 0.55, 0.2*Z>, 0.08 }
      cone { P + <0, 0.55, 0.2*Z>, 0.08, P + <0, 1.0, 0>, 0.04 }
    #end
  #end
  #for (I, -Parts, Parts)
    Bone(Deck(I/Parts, -0.9), Deck(I/Parts, 0.9), 0.15)
  #end
  pigment { rgb <0.86, 0.8, 0.68> }
  finish { ambient <0.05, 0.06, 0.08> diffuse 0.8 specular 0.15 roughness 0.05 }
}
// The cliffs that it grows from.
#declare Chance = seed(8);
blob {
  kernel "cubic" hardness 1
  #for (Side, -1, 1, 2)
    sphere { <Side*10.6, -3.2, 0>, 1.9 }
    sphere { <Side*12.4, 0, 0>, 2 }
    #for (I, 0, 130)
      #local H = -8 + 9*pow(rand(Chance), 0.6);
      sphere { <Side*(11.9 + 13*rand(Chance) + 0.35*H), H, 16*rand(Chance) - 5>, 1.1 + 1.4*rand(Chance) }
    #end
  #end
  pigment { rgb <0.32, 0.29, 0.27> }
  normal { granite 0.35 scale 1.5 }
  finish { ambient <0.05, 0.06, 0.08> diffuse 0.75 }
}
fog { fog_type 2 distance 9 rgb <0.8, 0.77, 0.72> fog_offset -4.6 fog_alt 0.7 turbulence 0.5 turb_depth 0.6 }
