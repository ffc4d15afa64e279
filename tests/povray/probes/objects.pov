// trace, inside, min_extent and max_extent of solids that have exact answers.
#version 3.7;
#macro Say(Name, X) #debug concat(Name, " ", str(X, 0, 6), "\n") #end
#macro Say3(Name, V) #debug concat(Name, " ", vstr(3, V, " ", 0, 6), "\n") #end
#macro Rounded(X) floor(X*1e6 + 0.5)/1e6 #end   // the sign of zero means nothing
#macro Hit(Name, O, P, D)
  #local N = <9, 9, 9>;
  #local H = trace(O, P, D, N);
  Say3(Name, H)
  Say3("  normal", <Rounded(N.x), Rounded(N.y), Rounded(N.z)>)
#end
#declare Ball = sphere { <1, 2, 3>, 2 }
#declare Cube = box { <-1, -2, -3>, <3, 2, 1> }
#declare Can = cylinder { 0, 3*y, 1 }
#declare Tip = cone { 0, 2, 3*y, 0 }
#declare Floor = plane { y, -1 }
#declare Ring = torus { 2, 0.5 }
#declare Hole = difference { object { Cube } object { Ball } }
#declare Both = intersection { object { Cube } object { Ball } }
#declare Blob = blob { threshold 0.5 sphere { 0, 2, 1 } }
Hit("sphere", Ball, <1, 2, -10>, z)
Hit("sphere, a long direction", Ball, <1, 2, -10>, 50*z)
Hit("sphere from within", Ball, <1, 2, 3>, x)
Hit("sphere missed", Ball, <10, 2, -10>, z)
Hit("box", Cube, <0, 0.5, -10>, z)
Hit("box from within", Cube, <0, 0, 0>, y)
Hit("box aslant", Cube, <-5, -4, -6>, <1, 1, 1>)
Hit("cylinder", Can, <-5, 1, 0>, x)
Hit("its cap", Can, <0.2, 9, 0.3>, -y)
Hit("cone", Tip, <-5, 1.5, 0>, x)
Hit("plane", Floor, <3, 5, 2>, <1, -2, 0>)
Hit("plane from below", Floor, <0, -5, 0>, y)
Hit("torus", Ring, <-5, 0, 0>, x)
Hit("torus through its hole", Ring, <0, 5, 0>, -y)
Hit("difference", Hole, <1, 1, -10>, z)
Hit("intersection", Both, <1, 1, -10>, z)
Hit("blob", Blob, <-5, 0, 0>, x)
Say("inside a sphere", inside(Ball, <1, 2, 4.9>))
Say("outside a sphere", inside(Ball, <1, 2, 5.1>))
Say("inside a plane", inside(Floor, <0, -2, 0>))
#declare Inverse = object { Ball inverse }
Say("inside an inverse", inside(Inverse, 0) + 10*inside(Inverse, <1, 2, 3>))
Say("inside a difference", inside(Hole, <1, 1.5, 0.9>) + 10*inside(Hole, <-0.9, -1.9, -2.9>))
#declare Pair = union { object { Ball } object { Cube } }
Say("inside a union", inside(Pair, <1, 3, 3>))
Say("inside a blob", inside(Blob, <1, 0, 0>) + 10*inside(Blob, <1.2, 0, 0>))
Say3("lowest of a sphere", min_extent(Ball)) Say3("highest of a sphere", max_extent(Ball))
Say3("lowest of a box", min_extent(Cube)) Say3("highest of a box", max_extent(Cube))
Say3("lowest of a cylinder", min_extent(Can)) Say3("highest of a cylinder", max_extent(Can))
#declare Moved = object { Cube scale 2 translate <1, 2, 3> }
Say3("lowest of a moved one", min_extent(Moved)) Say3("highest of a moved one", max_extent(Moved))
#declare Turned = object { Cube rotate 90*z }
Say3("lowest of a turned one", min_extent(Turned)) Say3("highest of a turned one", max_extent(Turned))
Say3("lowest of two", min_extent(Pair)) Say3("highest of two", max_extent(Pair))
#declare Egg = ovus { 1, 0.6 }
#declare Onion = ovus { 0.6, 1 sturm }
#declare Drop = ovus { 1, 0.1 }
#declare Ball2 = ovus { 1, 2.5 }
Hit("ovus at its bottom sphere", Egg, <-5, -0.6, 0.2>, x)
Hit("ovus between its spheres", Egg, <-5, 0.9, 0.1>, x)
Hit("ovus at its top sphere", Egg, <-5, 1.5, 0.1>, x)
Hit("ovus from above", Egg, <0, 9, 0>, -y)
Hit("ovus from below", Egg, <0, -9, 0>, y)
Hit("ovus from within", Egg, <0, 0.5, 0>, <1, 2, 3>)
Hit("ovus aslant", Egg, <-5, -4, -6>, <1, 1, 1.2>)
Hit("ovus missed", Egg, <-5, 1.5, 0.5>, x)
Hit("onion at its bottom sphere", Onion, <-5, -0.5, 0.2>, x)
Hit("onion between its spheres", Onion, <-5, 0, 0.1>, x)
Hit("onion at its top sphere", Onion, <-5, 1.2, 0.1>, x)
Hit("drop near its tip", Drop, <-5, 1.05, 0.03>, x)
Hit("drop between its spheres", Drop, <-5, 1.0, 0.03>, x)
Hit("ovus that is a sphere", Ball2, <-5, 0.5, 0.1>, x)
#macro InOvus(P) Say3("in ovus", <inside(Egg, P), inside(Onion, P), inside(Drop, P)>) #end
InOvus(<0, 0, 0>) InOvus(<0, -0.99, 0>) InOvus(<0, -1.01, 0>) InOvus(<0, 1.59, 0>) InOvus(<0, 1.61, 0>) InOvus(<0, 1.09, 0>)
InOvus(<0.7, 0.9, 0>) InOvus(<0.8, 0.9, 0>) InOvus(<0.99, 0, 0>) InOvus(<0.9, 1, 0>) InOvus(<0.5, -0.4, 0>) InOvus(<0, -0.58, 0>)
Say("an ovus holds none of its surface", inside(Egg, <0, -1, 0>) + inside(Egg, <0, 1.6, 0>))
Say3("lowest of an ovus", min_extent(Egg)) Say3("highest of an ovus", max_extent(Egg))
