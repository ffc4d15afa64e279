// Prints the sun's places.
// Both programs read this scene with their own files of these names and must print the same (tests/stdlib/compare.py).
#version 3.7;
global_settings { assumed_gamma 1 }
#include "sunpos.inc"
#macro Show(Text, V) #debug concat(Text, " ", str(V, 0, 6), "\n") #end
#macro Show3(Text, V) #debug concat(Text, " ", vstr(3, V, " ", 0, 6), "\n") #end
#macro Show5(Text, V) #debug concat(Text, " ", vstr(5, V, " ", 0, 6), "\n") #end
#macro At(Y, M, D, H, Min, Zone, Latitude, Longitude)
  #local Place = SunPos(Y, M, D, H, Min, Zone, Latitude, Longitude)/1e9;
  Show3("Sun", Place)
  Show("Al", Al)
  Show("Az", Az)
#end
At(2000, 6, 21, 12, 2, 0, 51.4667, 0)
At(2011, 12, 1, 23, 2, -75, -11.5, -80)
At(1995, 2, 28, 1, 30, 120, 35, 135)
At(2026, 9, 5, 0, 5, 15, 48.2, 16.4)
At(1969, 7, 20, 20, 17, 0, 28.6, -10.6)
