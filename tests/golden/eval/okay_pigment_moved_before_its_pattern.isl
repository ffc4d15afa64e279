// A pattern is moved as the plain colour was that stood in its place.
sphere { 0, 1 pigment { rgb 1 } translate 2*x pigment { checker } }
sphere { 0, 1 translate 3*y finish { ambient 1 } translate 2*x pigment { checker } }
sphere { 0, 1 pigment { rgb 1 scale 2 } pigment { gradient x scale 3 } }
sphere { 0, 1 texture { pigment { rgb 1 } rotate 90*z pigment { checker } translate x } }
#declare Plain = pigment { rgb 1 translate 5*z }
#declare Look = texture { pigment { rgb 1 } translate 6*z }
sphere { 0, 1 pigment { Plain } translate 2*x pigment { checker } }
sphere { 0, 1 texture { Look pigment { checker } } }
sphere { 0, 1 texture { Look } pigment { checker } }
#declare Ball = sphere { 0, 1 pigment { rgb 1 } translate 7*z }
object { Ball pigment { checker } }
object { Ball texture { pigment { checker } } }  // a texture of its own is not
#declare Red_ball = object { sphere { 0, 1 pigment { bozo scale 3 } } pigment { rgb x } scale 2 }
object { Red_ball pigment { checker } }  // six times as large
