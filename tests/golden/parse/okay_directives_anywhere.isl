union {
  #declare R = 1;
  sphere { #if (A) 0, #else x, #end R #local T = 2; scale T }
}
lathe { linear_spline 5, #while (I < 5) <I, 1> #end }
#declare V = #if (A) 1 #else 2 #end;
#declare W = (#if (A) 1 #else 2 #end);
