// A loop nests values without nesting its text: each is as deep as 64 levels, and told where it is deeper.
#declare P = pigment { rgb 1 }
#for (I, 1, 1000) #declare P = pigment { gradient x pigment_map { [0 P] [1 rgb 0] } } #end
#declare T = texture { pigment { rgb 1 } }
#for (I, 1, 1000) #declare T = texture { checker texture { T }, texture { pigment { rgb 0 } } } #end
#declare N = normal { bumps }
#for (I, 1, 1000) #declare N = normal { gradient x normal_map { [0 N] [1 dents 1] } } #end
#declare F = pigment { gradient x }
#macro Around(Inner) #local G = function { pigment { Inner } } pigment { function { G(x, y, z).gray } } #end
#for (I, 1, 1000) #declare F = Around(F) #end
#declare A = array[1] { 1 }
#for (I, 1, 1000) #declare B = array[1] #declare B[0] = A; #declare A = B; #end
