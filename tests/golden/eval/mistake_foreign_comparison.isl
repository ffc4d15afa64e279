#declare K = 3;
#if (K == 3 && K != 4) sphere { 0, 1 } #end
