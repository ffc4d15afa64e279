sphere { 0, 1 pigment { rgb 1 } finish { phong 1 subsurface { translucency 1 } } interior { media { emission 1 } ior 1.5 } }
#declare D = density { spherical density_map { [0 rgb 0] [1 rgb 1] } }
object { mesh { triangle { 0, x, y } } translate x }
camera { location z }
