// The block was never begun.
#if (0) union { #end
  sphere { 0, 1 }
#if (1) } #end
sphere { 0, wrong }
