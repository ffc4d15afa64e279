// A wave of pebbles: stones laid by size and tide along a curve; the ridge bends like the sea that has left it.
//   isl render scenes/gallery/pebbles.isl
#version 3.7;
#include "scatter.isl"
#include "random.isl"
global_settings { assumed_gamma 1 max_trace_level 3 }

camera { location <0.4, 4.6, -6.4> look_at <0, 0, -0.35> angle 38 }
light_source { <-8, 3.6, 1.5> rgb <1.5, 1.22, 0.9> }
light_source { <6, 8, -6> rgb <0.3, 0.36, 0.46> shadowless }

#declare Chance = Random_stream("pebbles", 3);
#declare Places = Scatter_rectangle(9, 9, 0.155, Chance);
#declare Stones = array[5] { <0.16, 0.17, 0.19>, <0.36, 0.34, 0.33>, <0.6, 0.56, 0.5>, <0.46, 0.3, 0.24>,
  <0.8, 0.77, 0.72> }
// The wave: a ridge that winds; stones are larger and lighter on its crest.
#macro Crest(P) exp(-pow((P.z - 0.9*sin(0.85*P.x + 0.4))/0.75, 2)) #end
#for (I, 0, dimension_size(Places, 1) - 1)
  #local P = Places[I] - <4.5, 0, 4.5>;
  #local H = Crest(P);
  #local Colour = Random_choice(Stones, Chance);
  #local Colour = Colour*(1 - 0.75*H) + <0.86, 0.83, 0.78>*0.75*H;
  blob {
    kernel "gaussian" hardness 2
    sphere { -0.3*x, 0.72 }
    sphere { <0.35, 0.05, 0.2*rand(Chance)>, 0.6 + 0.2*rand(Chance) }
    scale (0.075 + 0.05*H + 0.025*rand(Chance))*<1.15, 0.62, 0.95>
    rotate <20*rand(Chance) - 10, 360*rand(Chance), 0>
    translate P + (0.55*H + 0.03*rand(Chance))*y
    pigment { granite scale 0.6 color_map { [0 rgb 0.7*Colour] [1 rgb 1.15*Colour] } }
    finish { ambient 0.06 diffuse 0.75 specular 0.12 roughness 0.05 }
  }
#end
plane { y, -0.02 pigment { rgb <0.16, 0.145, 0.13> } finish { ambient 0.05 diffuse 0.7 } }
