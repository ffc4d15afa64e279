// Twelve lamps in a ring.
#include "stage.inc"
View()
#ifdef (Without) Sun() #else
  #for (I, 0, 11) light_source { <5*sin(I*pi/6), 5, 5*cos(I*pi/6)> rgb 0.15 } #end
#end
Still_life(Matt)
