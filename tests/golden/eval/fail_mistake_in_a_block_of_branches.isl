// A mistake within such a block ends it; the rest of it is not taken for another mistake.
#if (1) union { #else merge { #end
  sphere { 0, wrong }
  0, 1
}
#declare Pair = #if (1) union { #else merge { #end
  sphere { 0, wrong_too }
  scale <1, 2, 3>
}
#for (I, 0, 1)
  #if (I = 0) union { #end
    sphere { 0, 1 }
  #if (I = 1) } #end
#end
#if (1) nothing { #else union { #end
  sphere { 0, 1 }
}
sphere { 0, last }
