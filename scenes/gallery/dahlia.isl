// Phyllotaxis: six hundred petals by the golden angle. The young ones in the middle have melted into one another, the
// old ones outside have come apart.
//   isl render scenes/gallery/dahlia.isl
#version 3.7;
#include "growth.isl"
#include "easing.isl"
global_settings { assumed_gamma 1 max_trace_level 2 }

camera { location <0, 6.2, -4.3> look_at <0.05, 0, -0.18> angle 34 }
light_source { <-6, 4.5, 2.5> rgb <1.25, 1.12, 0.95> area_light 2*y, 2*z, 6, 6 jitter circular orient }
light_source { <6, 5, -4> rgb <0.22, 0.25, 0.4> shadowless }
plane { y, -0.5 pigment { rgb <0.035, 0.045, 0.06> } finish { ambient 0.1 diffuse 0.7 } }

#declare Count = 620;
blob {
  kernel "gaussian" hardness 4
  sphere { 0, 1 scale <1.5, 0.35, 1.5> translate -0.32*y pigment { rgb <0.12, 0.03, 0.1> } }
  #for (I, 0, Count - 1)
    #local T = I/Count;
    #local D = Growth_disc(I, Count);
    #local Out = vnormalize(D);
    #local R = vlength(D);
    // Petals lean out more and more, and grow longer.
    #local Foot = 1.45*D + (0.38*sqrt(max(0, 1 - R*R)) - 0.2)*y;
    #local Lean = radians(Ease_mix(8, 78, Ease_in(T, 0.8)));
    #local Axis = sin(Lean)*Out + cos(Lean)*y;
    #local Length = Ease_mix(0.06, 0.5, Ease_in(T, 0.9));
    cone { Foot, Ease_mix(0.052, 0.05, T), Foot + Length*Axis, Ease_mix(0.03, 0.075, T)
      pigment { color Ease_mix(rgb <1, 0.72, 0.32>,
        Ease_mix(rgb <0.9, 0.2, 0.22>, rgb <0.42, 0.05, 0.3>, Ease_in(T, 1.4)), Ease_out(T, 2)) }
    }
  #end
  finish { ambient 0.05 diffuse 0.75 specular 0.25 roughness 0.03 }
}
