// A lamp that takes light away.
#include "stage.inc"
View() Sun()
#ifndef (Without) light_source { <-4, 5, -3> rgb <-0.3, -0.2, 0> } #end
Still_life(Matt)
