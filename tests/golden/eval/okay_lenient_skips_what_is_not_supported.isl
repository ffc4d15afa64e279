#declare Box = box { -1, 1 }
object { Box translate x }
sphere { 0, 1 pigment { marble turbulence <1, 2, 3> color_map { [0 rgb 0] [1 rgb 1] } } finish { reflection .5 phong 1 } interior { ior 1.5 } }
fog { distance 10 }
sphere { 0, 2 pigment { checker rgb 1, rgb 0 scale 2 } finish { reflection rgb .5 diffuse .5 } }
sphere { 0, 3 texture { cells texture { pigment { rgb 1 } } texture { pigment { rgb 0 } } } }
object { difference { sphere { 0, 1 } sphere { x, 1 } } translate x }
camera { fisheye angle 220 location z }
light_source { 0, rgb 1 spotlight radius 15 point_at y fade_distance 2 }
