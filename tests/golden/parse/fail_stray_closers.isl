sphere { 0, 1 } }
#end
#else
#if (A) } #end
