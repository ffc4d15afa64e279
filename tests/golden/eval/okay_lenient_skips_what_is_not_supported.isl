#declare Letters = text { ttf "timrom.ttf" "a" 1, 0 }
object { Letters translate x }
union { Letters sphere { 0, 1 photons { target } } mesh2 { } }
difference { sphere { 0, 2 } Letters rotate 10*y }
sphere { 0, 3 clipped_by { Letters } }
light_source { 0, rgb 1 looks_like { prism { } } photons { } }
global_settings { radiosity { count 10 } max_trace_level 3 }
Letters
object { lathe { } }
sphere { 0, 1 pigment { rgb 1 } finish { phong 1 subsurface { translucency 1 } } interior { media { emission 1 } ior 1.5 } }
#declare D = density { spherical density_map { [0 rgb 0] [1 rgb 1] } }
