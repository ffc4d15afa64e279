// Light is bent by a single face as on its way into a body, whichever way its corners go round.
#include "stage.inc"
Clear_stage()
#declare Pane = material { texture { pigment { rgbt <1, 0.9, 0.8, 0.8> } } interior { ior 1.4 } }
#ifdef (Without) #declare Pane = material { texture { pigment { rgb 0.8 } } } #end
triangle { <-2, 0.1, 0>, <-0.2, 0.1, 0>, <-1.1, 2, 0> material { Pane } }
triangle { <0.2, 0.1, 0>, <1.1, 2, 0>, <2, 0.1, 0> material { Pane } }
polygon { 4, <-0.6, 1.2>, <0.6, 1.2>, <0, 2.4>, <-0.6, 1.2> material { Pane } translate -z }
disc { <2, 2.2, -0.5>, z, 0.5 material { Pane } }
