// A union of many solids of five kinds. Count: how many.
#version 3.7;
#ifndef (Count) #declare Count = 1000; #end
global_settings { assumed_gamma 1 }
camera { location <0, 0, -16> look_at 0 angle 45 }
light_source { <20, 30, -30>, 1 }
#declare Random = seed(5);
#declare Size = 2.5 / pow(Count, 1 / 3);
union {
  #for (I, 1, Count)
    #local Place = (<rand(Random), rand(Random), rand(Random)> - 0.5) * 10;
    #switch (mod(I, 5))
      #case (0) sphere { Place, Size } #break
      #case (1) box { Place - Size / 2, Place + Size } #break
      #case (2) cylinder { Place, Place + <Size, Size, 0>, Size / 2 } #break
      #case (3) cone { Place, Size, Place + <0, Size, Size>, 0 } #break
      #case (4) torus { Size, Size / 4 rotate 90 * rand(Random) * x translate Place } #break
    #end
  #end
  pigment { rgb <0.5, 0.7, 0.9> }
  finish { ambient 0.1 diffuse 0.7 }
}
