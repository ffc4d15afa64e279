// A moss tree: two thousand limbs forked from two, by the pipe model; moss where rain would fall, bark where it would
// not.
//   isl render scenes/gallery/moss_tree.isl
#version 3.7;
#include "branching.isl"
#include "random.isl"
global_settings { assumed_gamma 1 }

camera { location <0.2, 0.9, -9.2> look_at <0.1, 1.85, 0> angle 40 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.6, 0.7, 0.62>] [1 rgb <0.3, 0.45, 0.5>] } } }
light_source { <-12, 12, -3> rgb <1.9, 1.65, 1.0> }
light_source { <8, 6, -12> rgb <0.12, 0.15, 0.17> shadowless }

#declare Bark = texture {
  pigment { granite scale <0.3, 0.9, 0.3> color_map { [0.2 rgb <0.12, 0.085, 0.06>] [0.7 rgb <0.26, 0.2, 0.15>] } }
  normal { granite 0.4 scale <0.15, 0.5, 0.15> }
  finish { ambient 0.05 diffuse 0.75 }
}
#declare Moss = texture {
  pigment { bozo scale 0.12 turbulence 0.5
    color_map { [0.2 rgb <0.1, 0.19, 0.02>] [0.6 rgb <0.24, 0.36, 0.05>] [0.9 rgb <0.42, 0.5, 0.1>] } }
  normal { granite 0.7 scale 0.12 }
  finish { ambient 0.06 diffuse 0.8 }
}
#declare Skin = texture {
  slope { y }
  turbulence 0.06
  texture_map { [0.46 Bark] [0.6 Moss] }
}
#declare Chance = Random_stream("moss", 3);
#macro Branch_tip(Place, Axis, Radius)
  #for (K, 0, 4)
    sphere { Place + 0.12*Random_in_ball(0, 1, Chance), Random_between(0.03, 0.07, Chance) texture { Moss } }
  #end
#end
#declare Tree = blob {
  kernel "gaussian" hardness 3
  Branch_tree(<0, 0.2, 0>, <0.12, 1, 0>, 1.0, 0.3, 9, 0.6, Chance)
  Branch_tree(<0.1, 0.2, 0.1>, <-0.55, 1, 0.3>, 0.9, 0.26, 9, 0.6, Chance)
  #for (I, 0, 8)
    #local D = vrotate(x, (40*I + 20*rand(Chance))*y);
    cone { 0.45*y, 0.26, 0.55*D + 0.12*y, 0.14 }
    cone { 0.55*D + 0.12*y, 0.14, (1.2 + 0.6*rand(Chance))*D - 0.1*y, 0.04 }
  #end
  texture { Skin }
}
Tree
// Others of its kind, in the mist: copies, which cost next to nothing.
#for (I, 0, 8)
  object { Tree scale Random_between(0.9, 1.3, Chance) rotate 360*rand(Chance)*y
    translate <(I - 4)*4.2 + 2*rand(Chance) - (I = 4)*3, -0.1, 9 + 13*rand(Chance)> }
#end
// The ground.
blob {
  kernel "gaussian" hardness 2
  plane { y, -0.06, 0.06 }
  #for (I, 0, 120)
    sphere { Random_on_disc(<0, -0.12, 1>, y, 6, Chance), Random_between(0.15, 0.4, Chance) }
  #end
  texture { Skin }
}
fog { distance 30 rgb <0.62, 0.64, 0.46> }
