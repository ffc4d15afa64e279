// A random blob of 100 components that are hard for a grid: large balls of both signs overlap everywhere, and among them
// are balls down to a millionth of their size, thin plates, threads and half-spaces.
//
//   isl render bench/scenes/overlaps.isl -D Case=17 --stats overlaps.json
#version 3.7;
global_settings { assumed_gamma 1 }

#ifndef (Case) #declare Case = 0; #end
#declare Chance = seed(Case + 1);
#macro Between(A, B) (A + (B - A) * rand(Chance)) #end
#macro Place() <Between(-1, 1), Between(-1, 1), Between(-1, 1)> #end
#macro Direction() vnormalize(Place() + <1e-3, 0, 0>) #end
#macro Thin() pow(10, Between(-6, -1)) #end
#macro Sign() (rand(Chance) < 0.4 ? -1 : 1) #end

#declare Kernels = array[5] { "quartic", "cubic", "gaussian", "soft", "cauchy" }
#declare Large = 5 + int(Between(0, 60));

blob {
  threshold 1
  #for (I, 1, 100)
    #if (I = 1 | mod(I, 10) = 0)
      #local Kind = int(Between(0, 4.999));
      kernel Kernels[Kind] hardness Between(1, 8)
      #local Convolved = (mod(Kind, 4) = 0 & rand(Chance) < 0.3);
    #end
    #if (I <= Large)
      sphere { Place(), Between(0.5, 2) strength Sign() * Between(0.05, 1) }
    #else
      #switch (int(Between(0, 6.999)))
        #case (0) sphere { Place(), Thin() strength Sign() } #break
        #case (1)
          #if (Convolved) convolution on #end
          cylinder { Place(), Place(), Thin() strength Sign() }
          convolution off
        #break
        #case (2) cone { Place(), Thin(), Place(), Thin() strength Sign() } #break
        #case (3) triangle { Place(), Place(), Place(), Thin() strength Sign() } #break
        #case (4) disc { Place(), Direction(), Between(0.1, 1), Thin() strength Sign() } #break
        #case (5) box { Place() - 1, Place() + 1, Thin() strength Sign() } #break
        #case (6) plane { Direction(), Between(-1, 1), Thin() strength Sign() * 0.5 } #break
      #end
    #end
  #end
  pigment { rgb <0.8, 0.6, 0.4> }
}

camera { location <0, 1, -6> look_at 0 }
light_source { <5, 8, -6> rgb 1 }
background { rgb <0.7, 0.8, 0.9> }
