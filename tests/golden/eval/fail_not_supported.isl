isosurface { function { x } }
sphere { 0, 1 interior { ior 1.5 media { emission 1 } } }
sphere { 0, 1 finish { subsurface { translucency 1 } } }
#declare D = density { spherical }
#declare F = function(x) { x }
#declare Mesh = mesh { triangle { 0, x, y } }
object { Mesh translate x }
