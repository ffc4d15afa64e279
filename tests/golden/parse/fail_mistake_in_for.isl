#for (I, 1) sphere { I, 1 } #end
#for (3, 1, 2) sphere { 0, 1 } #end
sphere { 0, }}
