isosurface { function { x } }
sphere { 0, 1 photons { target } }
#declare Letters = text { ttf "timrom.ttf" "a" 1, 0 }
object { Letters translate x }
union { mesh { triangle { 0, x, y } } sphere { 0, 1 } }
light_source { 0, rgb 1 looks_like { prism { 0, 1, 4, 0, x, y, 0 } } }
media { scattering { 1, rgb 1 } }
sphere { 0, 1 interior { ior 1.5 media { emission 1 } } }
sphere { 0, 1 finish { subsurface { translucency 1 } } }
#declare D = density { spherical }
