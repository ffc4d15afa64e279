// A macro yields components; each knows the call that made it.
#macro Chain(N, P)
  #if (N > 0)
    sphere { P, 1, 1 }
    Chain(N - 1, P + x)
  #end
#end
#declare Worm = blob { Chain(3, 0) }
object { Worm translate y }
blob { Worm pigment { rgb 1 } }
Worm
