// Transforms as functions: their order, matrices, inverses.
#version 3.7;
#macro Say(Name, T)
  #local F = function { transform { T } }
  #local P = F(1, 2, 3);
  #debug concat(Name, " ", vstr(3, P, " ", 0, 9), "\n")
#end
#declare Moved = transform { translate <1, 2, 3> }
#declare Turned = transform { rotate <10, 20, 30> }
#declare Sized = transform { scale <2, 3, 4> }
Say("translate", Moved)
Say("rotate", Turned)
Say("scale", Sized)
Say("scale by a number", transform { scale 2 })
Say("mirror", transform { scale <-1, 1, 1> })
Say("in order", transform { translate x rotate 90*y scale 2 })
Say("in another order", transform { scale 2 rotate 90*y translate x })
Say("one after another", transform { Moved Turned Sized })
Say("backwards", transform { Sized Turned Moved })
Say("inverse", transform { Turned inverse })
Say("inverse of several", transform { translate <1, 2, 3> rotate <10, 20, 30> scale <2, 3, 4> inverse })
Say("there and back", transform { Moved Turned transform { Moved Turned inverse } })
Say("matrix", transform { matrix <1, 2, 3, 4, 5, 6, 7, 8, 10, 11, 12, 13> })
Say("shear", transform { matrix <1, 0.5, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0> })
Say("matrix, then inverse", transform { matrix <1, 2, 3, 4, 5, 6, 7, 8, 10, 11, 12, 13> inverse })
Say("nested", transform { transform { translate x } transform { rotate 90*z } })
Say("turned about a point", transform { translate -<1, 1, 1> rotate 180*z translate <1, 1, 1> })
#macro About(P, R) transform { translate -P rotate R translate P } #end
Say("by a macro", About(<1, 2, 4>, 90*y))
Say("a short vector", transform { translate <1, 2> })
Say("a number", transform { translate 5 })
Say("full turns", transform { rotate <360, -360, 720> })
