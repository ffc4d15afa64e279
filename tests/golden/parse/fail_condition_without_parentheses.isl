#if A > 3 sphere { 0, 1 } #end
#while A sphere { 0, 1 } #end
