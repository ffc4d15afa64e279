// Objects walked through by trace: each surface on the line is found once, and the walk ends.
#version 3.7;
#macro Count(Thing, From, Along)
  #local N = y; #local P = From; #local K = 0;
  #while (vlength(N) > 0 & K < 40)
    #local P = trace(Thing, P, Along, N);
    #if (vlength(N) > 0) #local K = K + 1; #end
  #end
  K
#end
#declare Ball = blob { threshold 0.5 sphere { <-0.5, 0, 0>, 1, 1 } sphere { <0.8, 0, 0>, 1, 1 } }
#declare Two = union { sphere { -0.7*x, 0.5 } box { <0.2, -0.5, -0.5>, <1, 0.4, 0.5> } }
#declare Cut = difference { box { -1, 1 } cylinder { -2*y, 2*y, 0.6 } sphere { <0.9, 0, 0>, 0.3 } }
#declare Ring = torus { 1, 0.25 rotate <33, 20, 10> translate <3, 1, 2> }
#debug concat(str(Count(Ball, <-3, 0.2, 0>, x), 0, 0), " ", str(Count(Ball, <-3, 0.2, 0>, <3, 0.01, 0.02>), 0, 0), "\n")
#debug concat(str(Count(Two, <-3, 0.1, 0.1>, x), 0, 0), " ", str(Count(Two, <0.5, -3, 0.1>, y), 0, 0), "\n")
#debug concat(str(Count(Cut, <-3, 0.1, 0.1>, x), 0, 0), " ", str(Count(Cut, <-3, 0.1, 0.1>, <1, 0.01, 0.2>), 0, 0), "\n")
#debug concat(str(Count(Ring, <-3, 1.1, 2.1>, x), 0, 0), " ", str(Count(Ring, <-3, 1.3, 2.1>, <6, 0.2, 0>), 0, 0), "\n")
