// Cloud forms: towers of soft balls over a sea at evening. Every tower is a sphere-flake with jitter whose balls have
// lost their edges in one another.
//   isl render scenes/gallery/clouds.isl
#version 3.7;
#include "random.isl"
global_settings { assumed_gamma 1 max_trace_level 3 }

camera { location <0, 2.2, -22> look_at <0, 5.4, 0> angle 44 }
sky_sphere {
  pigment { gradient y
    color_map { [0 rgb <1.0, 0.66, 0.42>] [0.1 rgb <0.86, 0.66, 0.6>] [0.3 rgb <0.46, 0.55, 0.72>]
      [0.8 rgb <0.16, 0.28, 0.52>] } }
}
light_source { <-60, 26, -8> rgb <1.35, 0.98, 0.66> }
light_source { <20, 40, -50> rgb <0.22, 0.27, 0.4> shadowless }
light_source { <0, -30, -10> rgb <0.2, 0.13, 0.13> shadowless }

#declare Chance = Random_stream("clouds", 4);
// A heap: balls on balls, upwards rather than down.
#macro Heap(C, R, Level)
  sphere { C, R }
  #if (Level > 0)
    #for (K, 1, 10)
      #local D = Random_on_sphere(0, 1, Chance)*<1, 0.8, 1> + 0.28*y;
      #if (C.y + R*D.y > 3 + 0.2*R)
        Heap(C + 0.86*R*D, R*Random_between(0.34, 0.52, Chance), Level - 1)
      #end
    #end
  #end
#end
#macro Cloud(P, Size)
  #for (J, 0, 8)
    #local W = Random_between(-1, 1, Chance);
    Heap(P + Size*<2.1*W, 0.42*(1 - W*W) + 0.1, 0.8*Random_between(-1, 1, Chance)>, Size*(0.75 - 0.3*abs(W)), 2)
  #end
  Heap(P + Size*<-0.3, 1.35, 0>, Size*0.72, 4)
#end
blob {
  kernel "gaussian" hardness 2.4
  Cloud(<-2.5, 3.4, 6>, 3)
  Cloud(<11, 3.3, 22>, 2.6)
  Cloud(<-17, 3.2, 30>, 2.4)
  // Flat below, as clouds are.
  kernel "cubic" hardness 2
  plane { y, 1.6, 0.6 strength -3 }
  pigment { rgb <0.95, 0.93, 0.92> }
  finish { ambient <0.05, 0.05, 0.07> diffuse 0.8 }
}
plane { y, 0
  pigment { rgb <0.02, 0.035, 0.05> }
  normal { average normal_map { [1 bumps 0.28 scale <1.6, 1, 0.5>] [1 bumps 0.2 scale <0.5, 1, 0.2>] } }
  finish { ambient 0 diffuse 0.5 reflection { 0.03, 0.9 falloff 4 } }
}
fog { fog_type 2 distance 60 rgb <0.95, 0.68, 0.48> fog_offset -0.5 fog_alt 1.2 }
