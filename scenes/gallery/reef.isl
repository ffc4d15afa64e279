// A coral reef: antlers, brains, fans, lettuce and tubes, each a blob of its own, in water that takes the red out of
// what is far.
//   isl render scenes/gallery/reef.isl
#version 3.7;
#include "branching.isl"
#include "growth.isl"
#include "random.isl"
global_settings { assumed_gamma 1 }

camera { location <0, 1.35, -7.6> look_at <0, 1.25, 0> angle 44 }
light_source { <-5, 14, -2> rgb <2.0, 1.9, 1.7> }
light_source { <5, 5, -10> rgb <0.3, 0.34, 0.4> shadowless }
sky_sphere { pigment { gradient y
  color_map { [0 rgb <0.02, 0.2, 0.32>] [0.25 rgb <0.03, 0.3, 0.46>] [1 rgb <0.25, 0.75, 0.85>] } } }
fog { distance 15 rgb <0.008, 0.12, 0.2> }
#default { finish { ambient 0.06 diffuse 0.75 specular 0.15 roughness 0.04 } }
#declare Chance = Random_stream("reef", 5);

// Antlers: forked trees whose tips are pale.
#macro Antler(P, Size, Low_colour, High_colour, Turn)
  #macro Branch_paint(Level, Share) pigment { color Low_colour + (High_colour - Low_colour)*pow(Share, 2) } #end
  blob {
    kernel "gaussian" hardness 3
    Branch_tree(0, y, 0.72, 0.15, 7, 0.6, Chance)
    scale Size rotate Turn*y translate P
  }
#end
Antler(<-2.2, 0.25, 0.2>, 1.0, rgb <0.7, 0.2, 0.16>, rgb <1, 0.72, 0.5>, 20)
Antler(<2.7, 0.1, 1.4>, 1.15, rgb <0.3, 0.2, 0.5>, rgb <0.75, 0.6, 0.95>, 140)
Antler(<-1.15, 0.2, 4.5>, 1.3, rgb <0.25, 0.3, 0.45>, rgb <0.6, 0.8, 0.9>, 230)
Antler(<0.35, 0.1, 2.6>, 1.1, rgb <0.6, 0.45, 0.12>, rgb <1, 0.9, 0.55>, 80)

// A fan, which fills its plane.
#macro Branch_paint(Level, Share) pigment { rgb <0.75, 0.1 + 0.2*Share, 0.3> } #end
blob {
  kernel "gaussian" hardness 4
  Branch_filling(<-1, 0.3, -0.1>, <1, 2.4, 0.1>, 0, 0.0062, 11, 0.5, Chance)
  rotate <4, -24, 6> translate <1.25, 0.1, 0.35>
}
// Brain coral: a ball in whose skin a furrow winds.
sphere { 0, 1 scale <0.85, 0.62, 0.8> translate <-0.6, 0.12, -0.9>
  pigment { rgb <0.75, 0.6, 0.25> }
  normal { crackle 2.4 turbulence 0.35 scale 0.17 }
}
// Lettuce.
blob {
  kernel "gaussian" hardness 2
  Growth_ruffle(0, 0.85, 22, 7, 0.16, 0.036)
  pigment { rgb <0.45, 0.68, 0.28> }
  rotate <-22, 30, -6> translate <1.75, 0.36, -1.3>
}
// Thorny ones, small, in front.
#macro Branch_paint(Level, Share) pigment { rgb <1, 0.3 + 0.35*Share, 0.12 + 0.2*Share> } #end
blob {
  kernel "gaussian" hardness 3
  Branch_coral(0, y, 0.42, 0.1, 4, 22, 0.5, Chance)
  translate <0.35, 0, -2.5>
}
// Anemones.
#macro Growth_paint(S) pigment { rgb <0.95, 0.45 + 0.4*S, 0.5 + 0.2*S> } #end
#for (I, 0, 4)
  blob {
    kernel "gaussian" hardness 4
    Growth_polyp(0, y + 0.25*Random_on_sphere(0, 1, Chance), 0.32, 0.11 + 0.04*rand(Chance), 16)
    translate <-2.6 + 0.33*I, 0.02, -2.2 + 0.55*mod(I, 2) + 0.2*rand(Chance)>
  }
#end
// The ground: sand and dead coral.
blob {
  kernel "cubic" hardness 2
  plane { y, -0.1, 0.1 }
  #for (I, 0, 150)
    #local P = Random_on_disc(<0, -0.15, 2>, y, 7, Chance);
    sphere { P, Random_between(0.15, 0.55, Chance) scale <1, 0.8, 1> }
  #end
  pigment { granite scale 2 color_map { [0.2 rgb <0.28, 0.25, 0.22>] [0.8 rgb <0.6, 0.55, 0.45>] } }
  normal { granite 0.4 scale 0.6 }
}
