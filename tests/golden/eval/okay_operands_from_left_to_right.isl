// The left operand is read before the right one runs, even where the right one is a macro that changes it.
#declare A = 1;
#declare V = <1, 2, 3>;
#macro Bump()
  #declare A = 10;
  #declare V = <10, 20, 30>;
  1
#end
#debug concat(str(A + Bump(), 0, 0), " ", str(A - 1, 0, 0), "\n")
#declare A = 1;
#declare V = <1, 2, 3>;
#debug concat(vstr(3, V * Bump(), " ", 0, 0), "\n")
#debug concat(vstr(3, -V + A * V, " ", 0, 0), " ", str(-(A < 2), 0, 0), str(!A, 0, 0), "\n")
