// Dew on a spider's web: the threads sag between their knots, and every drop holds the meadow upside down.
//   isl render scenes/gallery/web_of_dew.isl
#version 3.7;
#include "random.isl"
global_settings { assumed_gamma 1 max_trace_level 4 }

camera { location <-1.3, -0.75, -3.3> look_at <0.12, -0.02, 0> angle 34 }
// A meadow before sunrise, out of focus: dark below, a bright strip of sky above the wood.
sky_sphere {
  pigment {
    gradient y
    color_map {
      [0 rgb <0.01, 0.02, 0.01>] [0.42 rgb <0.03, 0.055, 0.02>] [0.54 rgb <0.05, 0.075, 0.04>]
      [0.6 rgb <0.2, 0.17, 0.08>]
      [0.68 rgb <1.7, 1.25, 0.7>] [0.8 rgb <0.5, 0.55, 0.6>] [1 rgb <0.2, 0.3, 0.45>]
    }
    scale 2 translate -y
  }
}
light_source { <-40, 36, 50> rgb <1.6, 1.3, 0.9> shadowless }
light_source { <-25, 8, -20> rgb <0.4, 0.45, 0.5> shadowless }

#declare Chance = Random_stream("web", 6);
#declare Spokes = 17;
#declare Rounds = 13;
#declare Angle = array[Spokes + 1];
#for (I, 0, Spokes - 1) #declare Angle[I] = 360*(I + 0.5*rand(Chance))/Spokes; #end
#declare Angle[Spokes] = Angle[0] + 360;
#macro Web_knot(I, J) (vrotate((0.16 + 0.155*J)*x, Angle[I]*z)*<1.1, 1, 0> - 0.012*J*z) #end

// A thread that sags from A to B, with drops along it that grow towards its middle.
#macro Thread(A, B, Sag, Drops)
  #local Before = A;
  #for (K, 1, 8)
    #local T = K/8;
    #local P = A + (B - A)*T - Sag*4*T*(1 - T)*y;
    cylinder { Before, P, 0.0055 }
    #local Before = P;
  #end
  #for (K, 1, Drops)
    #local T = (K - 0.5 + 0.4*(rand(Chance) - 0.5))/Drops;
    #local R = 0.013 + 0.026*pow(rand(Chance), 2);
    sphere { A + (B - A)*T - (Sag*4*T*(1 - T) + 0.7*R)*y, R }
  #end
#end
blob {
  kernel "gaussian" hardness 4
  #for (I, 0, Spokes - 1)
    Thread(0, Web_knot(I, Rounds + 4), 0.01, 14)
    #for (J, 1, Rounds)
      Thread(Web_knot(I, J), Web_knot(I + 1, J), 0.018 + 0.004*J, 3 + int(J/2))
    #end
  #end
  pigment { rgbf <0.97, 0.99, 1, 0.96> }
  finish { ambient 0 diffuse 0.05 specular 1 roughness 0.004 }
  interior { ior 1.33 }
}
