#if (Merge) merge { #else union { #end
  sphere { 0, 1 }
  #if (A) #local B = 1; difference { #else intersection { #end box { 0, 1 } }
}
