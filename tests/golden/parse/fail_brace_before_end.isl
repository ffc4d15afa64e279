#if (A)
  union { sphere { 0, 1 }
#end
sphere { 0, 1 }
