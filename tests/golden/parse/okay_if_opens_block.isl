#if (Merge) merge { #else union { #end
  sphere { 0, 1 }
  #if (A) #local B = 1; difference { #else intersection { #end box { 0, 1 } }
}
#ifdef (Cut) difference { #end
  sphere { 0, 1 }
#ifdef (Cut) box { 0, 1 } } #end
#declare Ring = torus { 1, 0.1 #if (A) scale 2 } #else } #end
#if (A)
  #declare Planes = intersection {
#else
  #declare Planes = union {
#end
  plane { y, 0 } };
