// Melting letters: a word of round strokes, and drops that run from it. The same strength holds strokes, runs and
// drops together.
//   isl render scenes/gallery/melting.isl
#version 3.7;
#include "curves.isl"
global_settings { assumed_gamma 1 max_trace_level 2 }

camera { location <0.3, 1.5, -9> look_at <-0.02, -0.12, 0> angle 48 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.74, 0.73, 0.74>] [0.6 rgb <0.8, 0.85, 0.95>] [1 rgb 1.2] } } }
light_source { <-6, 9, -7> rgb <1, 0.92, 0.8>*0.9 area_light 3*x, 3*z, 8, 8 jitter circular orient }
light_source { <7, 4, -8> rgb <0.25, 0.28, 0.34> shadowless }

#declare Red = texture {
  pigment { rgb <0.72, 0.03, 0.02> }
  finish { ambient 0.12 diffuse 0.75 specular 0.6 roughness 0.008 reflection { 0.02, 0.6 falloff 4 } }
}
#declare R = 0.2;
#macro Stroke(A, B) cylinder { <A.x, A.y, 0>, <B.x, B.y, 0>, R } #end
#macro Arc(C, Radius, From, To)
  #for (K, 0, 5)
    #local A = radians(From + (To - From)*K/6);
    #local B = radians(From + (To - From)*(K + 1)/6);
    Stroke(<C.x + Radius*cos(A), C.y + Radius*sin(A)>, <C.x + Radius*cos(B), C.y + Radius*sin(B)>)
  #end
#end
#declare Chance = seed(7);
#macro Drip(X, Y, Length)
  #local Waist = R*(0.34 + 0.1*rand(Chance));
  cylinder { <X, Y, 0>, <X, Y - Length, 0>, Waist }
  cylinder { <X, Y - Length, 0>, <X, Y - Length - 0.22, 0>, R*0.75 }
#end
blob {
  kernel "quartic" hardness 1.6 convolution on
  // m e l t
  Stroke(<-3.2, -0.6>, <-3.2, 0.6>) Arc(<-2.75, 0.2>, 0.45, 180, 0) Stroke(<-2.3, 0.2>, <-2.3, -0.6>)
  Arc(<-1.85, 0.2>, 0.45, 180, 0) Stroke(<-1.4, 0.2>, <-1.4, -0.6>)
  Arc(<-0.1, 0>, 0.62, 0, 318) Stroke(<-0.7, 0>, <0.52, 0>)
  Stroke(<1.35, -0.6>, <1.35, 1.6>)
  Stroke(<2.55, -0.35>, <2.55, 1.3>) Arc(<2.9, -0.3>, 0.35, 180, 300) Stroke(<2.1, 0.6>, <3.1, 0.6>)
  Drip(-3.2, -0.6, 0.45) Drip(-2.3, -0.6, 0.8) Drip(-1.4, -0.6, 0.25) Drip(-0.25, -0.62, 0.55) Drip(1.35, -0.6, 0.7)
  Drip(2.85, -0.65, 0.3) Drip(0.5, 0, 0.2) Drip(2.15, 0.6, 0.35)
  // What has reached the table.
  kernel "gaussian" hardness 2 convolution off
  #for (I, 0, 6)
    sphere { 0, 1 scale <0.35 + 0.25*rand(Chance), 0.09, 0.25 + 0.15*rand(Chance)>
      translate <-3.2 + 1.02*I + 0.2*rand(Chance), -1.72, -0.1> }
  #end
  disc { <0, -1.76, 0>, y, 0.6, 0.05 scale <4.3, 1, 0.7> }
  texture { Red }
}
fog { distance 110 rgb <0.74, 0.73, 0.74> }
plane { y, -1.8 pigment { rgb <0.86, 0.85, 0.83> }
  finish { ambient 0.12 diffuse 0.75 reflection { 0, 0.25 falloff 4 } } }
