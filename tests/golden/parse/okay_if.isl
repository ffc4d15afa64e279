#if (A > 1 & B) sphere { 0, 1 } #elseif (A = 2) box { 0, 1 } #else plane { y, 0 } #end
#ifdef (A) A #end
#ifndef (B[1]) #declare B = 1; #else B #end
