// The Lorenz attractor as one ribbon: four thousand steps of the weather, convolved into a single thread that melts
// where it passes near itself. Colour is the speed.
//   isl render scenes/gallery/lorenz.isl
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 0, -86> look_at <0, 0, 0> angle 40 }
background { rgb <0.012, 0.014, 0.022> }
light_source { <-50, 80, -50> rgb <1.3, 1.2, 1.0> }
light_source { <90, 10, -50> rgb <0.3, 0.38, 0.6> }
light_source { <0, -80, 30> rgb <0.3, 0.4, 0.8> shadowless }

#declare Slow = srgb <0.2, 0.3, 0.55>;
#declare Medium = srgb <0.87, 0.35, 0.3>;
#declare Fast = srgb <1, 0.85, 0.5>;
#macro Speed_colour(V)
  #local S = max(0, min(1, V));
  (S < 0.5 ? Slow + (Medium - Slow)*2*S : Medium + (Fast - Medium)*(2*S - 1))
#end
#macro Slope(P) <10*(P.y - P.x), P.x*(28 - P.z) - P.y, P.x*P.y - 8/3*P.z> #end

blob {
  kernel "quartic" hardness 2 convolution on
  #declare P = <0.9, 0.4, 14>;
  #declare Before = P;
  #for (I, 1, 4200)
    #declare V = Slope(P);
    #declare W = Slope((P + 0.004*V));
    #declare P = P + 0.008*W;
    cylinder { (<Before.x, Before.z - 25, Before.y>), (<P.x, P.z - 25, P.y>), 0.3
      texture {
        pigment { color Speed_colour(vlength(V)/170) }
        finish { ambient 0.02 diffuse 0.75 specular 0.5 roughness 0.02 }
      }
    }
    #declare Before = P;
  #end
  rotate <0, 40, 0> rotate -8*z
}
