#declare Sizes = array[3] { 1, 2, 3 }
#for (K, 0, 3) sphere { Sizes[K]*x, 0.2 } #end
