isosurface { function { x } }
sphere { 0, 1 photons { target } }
#declare Tube = sphere_sweep { linear_spline 2, 0, 1, x, 1 }
object { Tube translate x }
union { mesh { triangle { 0, x, y } } sphere { 0, 1 } }
light_source { 0, rgb 1 looks_like { sor { 3, 0, x, y } } }
media { scattering { 1, rgb 1 } }
sphere { 0, 1 interior { ior 1.5 media { emission 1 } } }
sphere { 0, 1 finish { subsurface { translucency 1 } } }
#declare D = density { spherical }
