#declare Tube = sphere_sweep { linear_spline 2, 0, 1, x, 1 }
object { Tube translate x }
union { Tube sphere { 0, 1 photons { target } } mesh2 { } }
difference { sphere { 0, 2 } Tube rotate 10*y }
sphere { 0, 3 clipped_by { Tube } }
light_source { 0, rgb 1 looks_like { sor { } } photons { } }
global_settings { radiosity { count 10 } max_trace_level 3 }
Tube
object { lathe { } }
sphere { 0, 1 pigment { rgb 1 } finish { phong 1 subsurface { translucency 1 } } interior { media { emission 1 } ior 1.5 } }
#declare D = density { spherical density_map { [0 rgb 0] [1 rgb 1] } }
