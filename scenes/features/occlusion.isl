// Ambient occlusion alone: no lamp, and still every crease of the flake is seen.
#version 3.7;
global_settings { assumed_gamma 1 ambient_occlusion { distance 1.6 } }
#default { finish { ambient 1 diffuse 0 } }

camera { location <0, 1.7, -4.6> look_at <0, 0.05, 0> angle 38 }
background { rgb <0.93, 0.93, 0.95> }
plane { y, -1.02 pigment { rgb <0.93, 0.93, 0.95> } }

#macro Ball(At, Up, Radius, Levels)
  sphere { At, Radius pigment { rgb <0.95, 0.75, 0.5> + Levels * <-0.03, 0.02, 0.12> } }
  #if (Levels > 0)
    #local Side = vnormalize(vcross(Up, <0.3, 0.5, 0.81>));
    #for (I, 0, 8)
      #local D = vaxis_rotate(vaxis_rotate(Up, Side, (I < 6 ? 88 : 38)), Up, (I < 6 ? 60 * I : 30 + 120 * I));
      Ball(At + 1.33 * Radius * D, D, Radius / 3, Levels - 1)
    #end
  #end
#end
blob { kernel "quartic" hardness 4 Ball(<0, 0, 0>, vnormalize(<0.1, 1, -0.2>), 0.72, 3) }
