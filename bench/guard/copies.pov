// 1,000 copies of a small blob, each at a place and an angle of its own.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 14, -30> look_at <0, 0, 4> angle 50 }
light_source { <20, 40, -30>, 1 }
plane { y, 0 pigment { rgb 0.7 } }
#declare Sprout = blob {
  threshold 0.5
  #for (I, 0, 5) sphere { <0.15 * sin(2 * I), 0.2 * I, 0.15 * cos(2 * I)>, 0.45, 1 } #end
  #for (I, 0, 2) cylinder { <0, 0.7, 0>, vrotate(<0.7, 0.6, 0>, 120 * I * y) + 0.7 * y, 0.25, 1 } #end
}
#declare Random = seed(3);
#for (I, 1, 1000)
  object {
    Sprout
    rotate 360 * rand(Random) * y
    translate <rand(Random) - 0.5, 0, rand(Random) - 0.5> * 40
    pigment { rgb <0.9, 0.3 + 0.4 * rand(Random), 0.3> }
  }
#end
