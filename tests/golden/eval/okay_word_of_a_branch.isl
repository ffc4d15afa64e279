// The word of a block may come from a branch.
#macro Both(Merge) #if (Merge) merge #else union #end { sphere { 0, 1 } sphere { x, 1 } } #end
Both(1)
object { Both(0) translate y }
#declare Named = #if (0) merge #else #if (1) difference #else union #end #end { sphere { 0, 1 } box { 0, 1 } }
Named
sphere { 0, 1 texture { #if (1) pigment #else finish #end { rgb 1 } } }
