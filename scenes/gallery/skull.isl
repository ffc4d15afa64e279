// A skull of metaballs: some forty balls and limbs, and ten that take away. Bone is what remains.
//   isl render scenes/gallery/skull.isl
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <-2.2, 0.4, -6.6> look_at <0.05, -0.02, 0> angle 36 }
background { rgb <0.012, 0.011, 0.012> }
light_source { <-6, 5, -3.2> rgb <1.35, 1.2, 0.98> area_light 1.5*y, 1.5*z, 5, 5 adaptive 1 circular orient }
light_source { <6, 2, 4> rgb <0.35, 0.45, 0.65> }
light_source { <2, -4, -6> rgb <0.07, 0.06, 0.07> shadowless }

#macro Both(P, R, S, Shape)
  #for (Side, -1, 1, 2)
    sphere { 0, R strength S scale Shape translate P*<Side, 1, 1> }
  #end
#end
blob {
  kernel "gaussian" hardness 3
  // The vault.
  sphere { 0, 1 scale <0.82, 0.8, 1.02> translate <0, 0.5, 0.22> }
  sphere { 0, 0.5 strength 0.5 scale <1.15, 0.8, 0.8> translate <0, 0.52, -0.5> }
  // The face, which the sockets are cut into.
  sphere { 0, 0.56 scale <1.05, 1.15, 0.9> translate <0, -0.2, -0.4> }
  // Brows, cheekbones, bridge of the nose, upper jaw.
  Both(<0.33, 0.22, -0.74>, 0.17, 0.6, <1.6, 0.5, 0.8>)
  Both(<0.55, -0.3, -0.6>, 0.19, 0.9, <1, 0.65, 1.1>)
  Both(<0.62, -0.02, -0.58>, 0.09, 0.7, <0.8, 1.9, 1>)
  Both(<0.72, -0.27, -0.15>, 0.13, 0.9, <0.7, 0.6, 3>)
  cone { <0, 0.12, -0.78>, 0.11, <0, -0.16, -0.88>, 0.06 }
  sphere { 0, 0.42 scale <0.9, 0.6, 0.85> translate <0, -0.52, -0.5> }
  // Teeth.
  kernel "quartic" hardness 6
  #for (I, -4, 4)
    #local A = radians(15*I);
    cone { <0.4*sin(A), -0.72, -0.38 - 0.46*cos(A)>, 0.058, <0.37*sin(A), -0.9, -0.38 - 0.42*cos(A)>, 0.05 }
    cone { <0.37*sin(A), -1.02, -0.36 - 0.42*cos(A)>, 0.048, <0.39*sin(A), -1.16, -0.36 - 0.43*cos(A)>, 0.054 }
  #end
  // The lower jaw.
  kernel "gaussian" hardness 3
  #for (Side, -1, 1, 2)
    cone { <0.66*Side, -0.32, 0.0>, 0.11, <0.58*Side, -0.95, -0.1>, 0.14 }
    cone { <0.58*Side, -0.95, -0.1>, 0.14, <0.22*Side, -1.3, -0.7>, 0.15 }
  #end
  sphere { <0, -1.33, -0.76>, 0.19 }
  // What is taken away: sockets, nose, temples.
  kernel "gaussian" hardness 4
  Both(<0.33, -0.05, -0.92>, 0.24, -5, <1.05, 0.95, 1.2>)
  Both(<0.31, -0.05, -0.62>, 0.22, -5, <1, 0.95, 1.2>)
  Both(<0.065, -0.36, -0.9>, 0.085, -5, <0.75, 1.6, 2>)
  Both(<0.95, 0.02, -0.36>, 0.24, -1.4, <0.8, 1, 1.2>)
  // Hollows below the cheekbones.
  Both(<0.62, -0.66, -0.62>, 0.2, -1.5, <1, 1.1, 1>)
  pigment { granite scale 2.5 color_map { [0.2 rgb <0.6, 0.5, 0.36>] [0.6 rgb <0.86, 0.79, 0.65>] } }
  normal { granite 0.06 scale 0.8 }
  finish { ambient 0.01 diffuse 0.8 specular 0.2 roughness 0.04 }
  translate 0.15*y
}
fog { distance 24 rgb <0.012, 0.011, 0.012> }
plane { y, -1.32
  pigment { rgb <0.05, 0.045, 0.045> }
  finish { ambient 0 diffuse 0.6 reflection { 0.02, 0.4 falloff 4 } }
}
