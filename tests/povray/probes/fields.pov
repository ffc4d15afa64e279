// Noise and the functions that functions.inc names, by their numbers.
#version 3.7;
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 12), "\n") #end
#declare Noise = function { internal(76) }
#declare Generated = function { internal(78) }
Say("noise", Noise(0.3, 0.2, 0.1))
#for (G, 0, 4)
  Say("at a point", Generated(0.3, -20.2, 7.1, G))
  Say("on the lattice", Generated(3, -2, 7, G))
  Say("far away", Generated(1000.25, -12345.5, 0.125, G))
#end
#for (I, 0, 9)
  Say("noise 1", Generated(-7.31*I, I*I*0.37, 2.11*I, 1))
  Say("noise 2", Generated(-7.31*I, I*I*0.37, 2.11*I, 2))
  Say("noise 3", Generated(-7.31*I, I*I*0.37, 2.11*I, 3))
#end
#declare Crossed_trough = function { internal(11) }
Say("crossed_trough", Crossed_trough(0.3,0.4,0.5,0.6))
Say("crossed_trough elsewhere", Crossed_trough(-0.7,1.4,-0.9,0.6))
#declare Cubic_saddle = function { internal(12) }
Say("cubic_saddle", Cubic_saddle(0.3,0.4,0.5,0.6))
Say("cubic_saddle elsewhere", Cubic_saddle(-0.7,1.4,-0.9,0.6))
#declare Cushion = function { internal(13) }
Say("cushion", Cushion(0.3,0.4,0.5,0.6))
Say("cushion elsewhere", Cushion(-0.7,1.4,-0.9,0.6))
#declare Odd = function { internal(43) }
Say("odd", Odd(0.3,0.4,0.5,0.6))
Say("odd elsewhere", Odd(-0.7,1.4,-0.9,0.6))
#declare Devils_curve = function { internal(14) }
Say("devils_curve", Devils_curve(0.3,0.4,0.5,0.6))
Say("devils_curve elsewhere", Devils_curve(-0.7,1.4,-0.9,0.6))
#declare Glob = function { internal(22) }
Say("glob", Glob(0.3,0.4,0.5,0.6))
Say("glob elsewhere", Glob(-0.7,1.4,-0.9,0.6))
#declare Heart = function { internal(23) }
Say("heart", Heart(0.3,0.4,0.5,0.6))
Say("heart elsewhere", Heart(-0.7,1.4,-0.9,0.6))
#declare Hunt_surface = function { internal(30) }
Say("hunt_surface", Hunt_surface(0.3,0.4,0.5,0.0006))
Say("hunt_surface elsewhere", Hunt_surface(-0.7,1.4,-0.9,0.0006))
#declare Klein_bottle = function { internal(35) }
Say("klein_bottle", Klein_bottle(0.3,0.4,0.5,0.6))
Say("klein_bottle elsewhere", Klein_bottle(-0.7,1.4,-0.9,0.6))
#declare Kummer_surface_v1 = function { internal(36) }
Say("kummer_surface_v1", Kummer_surface_v1(0.3,0.4,0.5,0.6))
Say("kummer_surface_v1 elsewhere", Kummer_surface_v1(-0.7,1.4,-0.9,0.6))
#declare Lemniscate_of_gerono = function { internal(38) }
Say("lemniscate_of_gerono", Lemniscate_of_gerono(0.3,0.4,0.5,0.6))
Say("lemniscate_of_gerono elsewhere", Lemniscate_of_gerono(-0.7,1.4,-0.9,0.6))
#declare Mitre = function { internal(41) }
Say("mitre", Mitre(0.3,0.4,0.5,0.6))
Say("mitre elsewhere", Mitre(-0.7,1.4,-0.9,0.6))
#declare Nodal_cubic = function { internal(42) }
Say("nodal_cubic", Nodal_cubic(0.3,0.4,0.5,0.6))
Say("nodal_cubic elsewhere", Nodal_cubic(-0.7,1.4,-0.9,0.6))
#declare Paraboloid = function { internal(45) }
Say("paraboloid", Paraboloid(0.3,0.4,0.5,0.6))
Say("paraboloid elsewhere", Paraboloid(-0.7,1.4,-0.9,0.6))
#declare Pillow = function { internal(48) }
Say("pillow", Pillow(0.3,0.4,0.5,0.6))
Say("pillow elsewhere", Pillow(-0.7,1.4,-0.9,0.6))
#declare Piriform = function { internal(49) }
Say("piriform", Piriform(0.3,0.4,0.5,0.6))
Say("piriform elsewhere", Piriform(-0.7,1.4,-0.9,0.6))
#declare Quartic_paraboloid = function { internal(54) }
Say("quartic_paraboloid", Quartic_paraboloid(0.3,0.4,0.5,0.6))
Say("quartic_paraboloid elsewhere", Quartic_paraboloid(-0.7,1.4,-0.9,0.6))
#declare Quartic_saddle = function { internal(55) }
Say("quartic_saddle", Quartic_saddle(0.3,0.4,0.5,0.6))
Say("quartic_saddle elsewhere", Quartic_saddle(-0.7,1.4,-0.9,0.6))
#declare Steiners_roman = function { internal(65) }
Say("steiners_roman", Steiners_roman(0.3,0.4,0.5,0.6))
Say("steiners_roman elsewhere", Steiners_roman(-0.7,1.4,-0.9,0.6))
#declare Torus_gumdrop = function { internal(72) }
Say("torus_gumdrop", Torus_gumdrop(0.3,0.4,0.5,0.6))
Say("torus_gumdrop elsewhere", Torus_gumdrop(-0.7,1.4,-0.9,0.6))
#declare Umbrella = function { internal(73) }
Say("umbrella", Umbrella(0.3,0.4,0.5,0.6))
Say("umbrella elsewhere", Umbrella(-0.7,1.4,-0.9,0.6))
#declare Ellipsoid = function { internal(17) }
Say("ellipsoid", Ellipsoid(0.3,0.4,0.5,0.5,0.3,0.2))
Say("ellipsoid elsewhere", Ellipsoid(-0.7,1.4,-0.9,0.5,0.3,0.2))
#declare Ph = function { internal(47) }
Say("ph", Ph(0.3,0.4,0.5))
Say("ph elsewhere", Ph(-0.7,1.4,-0.9))
#declare R = function { internal(57) }
Say("r", R(0.3,0.4,0.5))
Say("r elsewhere", R(-0.7,1.4,-0.9))
#declare Rounded_box = function { internal(60) }
Say("rounded_box", Rounded_box(0.3,0.4,0.5,0.1,0.2,0.3,0.4))
Say("rounded_box elsewhere", Rounded_box(-0.7,1.4,-0.9,0.1,0.2,0.3,0.4))
#declare Sphere = function { internal(61) }
Say("sphere", Sphere(0.3,0.4,0.5,0.4))
Say("sphere elsewhere", Sphere(-0.7,1.4,-0.9,0.4))
#declare Superellipsoid = function { internal(68) }
Say("superellipsoid", Superellipsoid(0.3,0.4,0.5,0.5,0.7))
Say("superellipsoid elsewhere", Superellipsoid(-0.7,1.4,-0.9,0.5,0.7))
#declare Th = function { internal(69) }
Say("th", Th(0.3,0.4,0.5))
Say("th elsewhere", Th(-0.7,1.4,-0.9))
#declare Torus = function { internal(70) }
Say("torus", Torus(0.3,0.4,0.5,0.9,0.1))
Say("torus elsewhere", Torus(-0.7,1.4,-0.9,0.9,0.1))
Say("clipped", Paraboloid(30,0,0,1))
Say("clipped above", Paraboloid(30,0,0,-1))
#declare Hetero = function { internal(29) }
#declare Ridged = function { internal(59) }
#for (O, 4, 1, -0.5)  // downwards: POV-Ray keeps amplitudes of the first call, and those of more octaves do for fewer
  Say("hetero_mf", Hetero(0.3, 0.4, 0.5, 0.6, 2.2, O, 0.9, 0, 2))
  Say("hetero_mf, weighted", Hetero(-0.3, 0.4, 7.5, 0.6, 2.2, O, 0.9, 1.5, 1))
  Say("hetero_mf, weighted twice", Hetero(-0.3, 0.4, 7.5, 0.6, 2.2, O, 0.2, 2, 3))
  Say("ridged_mf", Ridged(0.3, 0.4, 0.5, 0.6, 2.2, O, 0.9, 1.5, 2))
#end
Say("hetero_mf of half an octave", Hetero(0.3, 0.4, 0.5, 0.6, 2.2, 0.5, 0.9, 1, 2))
Say("ridged_mf of no octave", Ridged(0.3, 0.4, 0.5, 0.6, 2.2, 0, 0.9, 1.5, 2))
#declare Helix1 = function { internal(25) }
#declare Helix2 = function { internal(26) }
#for (I, -2, 2, 0.4)
  Say("helix1", Helix1(0.7, I, -0.4, 2, 3, 0.1, 0.8, 1, 1, 0))
  Say("helix1, turned squares", Helix1(-0.7, I, 0.4, 1, 2.5, 0.1, 0.8, 1.5, 0, 30))
  Say("helix1, rounded", Helix1(0.7, I, 0.4, 3, 2.5, 0.1, 0.8, 0.7, 0.4, 10))
  Say("helix2", Helix2(0.7, I, -0.4, 2, 3, 0.3, 0.2, 1, 1, 0))
  Say("helix2, diamonds", Helix2(-0.7, I, -0.4, 2, 3, 0.3, 0.2, 1, 2, 30))
  Say("helix2, squares", Helix2(-0.7, I, -0.4, 2, 3, 0.3, 0.2, 1, 0, 30))
#end
