// Hair on a body: threads that grow out of large balls which overlap, all one blob.
//
//   isl render bench/scenes/hair.isl -s 800x600 --samples 1 -t 2 --stats hair.json
#version 3.7;
global_settings { assumed_gamma 1 }

#ifndef (Threads) #declare Threads = 50000; #end
#ifndef (Thickness) #declare Thickness = 0.002; #end
#declare Chance = seed(50);
#macro Between(A, B) (A + (B - A) * rand(Chance)) #end

blob {
  threshold 1
  kernel "quartic" hardness 4
  #for (I, 0, 15)
    sphere { 0.25 * <cos(I), sin(1.7 * I), cos(2.3 * I)>, 0.75 strength (mod(I, 4) = 3 ? -0.3 : 0.5) }
  #end
  #for (I, 1, Threads)
    #local Up = vnormalize(<Between(-1, 1), Between(-1, 1), Between(-1, 1)> + <0, 1e-3, 0>);
    #local Bend = 0.25 * <Between(-1, 1), Between(-1, 0.2), Between(-1, 1)>;
    cylinder { 0.7 * Up, 1.2 * Up + Bend, Thickness }
  #end
  pigment { rgb <0.55, 0.35, 0.2> }
}

camera { location <0, 0.8, -5.4> look_at 0 angle 40 }
light_source { <5, 8, -6> rgb 1 }
background { rgb <0.7, 0.8, 0.9> }
