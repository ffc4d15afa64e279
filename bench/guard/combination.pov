// A box with holes: Holes by Holes cylinders are subtracted from it.
#version 3.7;
#ifndef (Holes) #declare Holes = 40; #end
global_settings { assumed_gamma 1 }
camera { location <7, 9, -11> look_at 0 angle 45 }
light_source { <10, 30, -20>, 1 }
light_source { <-10, 10, -20>, 0.3 }
difference {
  box { <-4, -0.5, -4>, <4, 0.5, 4> }
  #for (I, 0, Holes - 1)
    #for (K, 0, Holes - 1)
      cylinder {
        <(I + 0.5) / Holes * 8 - 4, -1, (K + 0.5) / Holes * 8 - 4>, <(I + 0.5) / Holes * 8 - 4, 1, (K + 0.5) / Holes * 8 - 4>, 3 / Holes
      }
    #end
  #end
  pigment { rgb <0.9, 0.8, 0.6> }
}
