// Branches that are not taken together: each mistake is told once, and reading goes on.
#if (1) union { #end
  sphere { 0, 1 }
#if (0) } #end
