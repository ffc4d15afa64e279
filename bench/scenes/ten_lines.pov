// Ten lines, for the time that it takes to look at a scene: bench/startup.sh.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 1, 0> }
light_source { <5, 8, -6>, 1 }
plane { y, 0 pigment { rgb 0.8 } }
#declare Limb = 0.8;
blob { threshold 0.5
  sphere { <-Limb, 1, 0>, 1.2, 1 } sphere { <Limb, 1, 0>, 1.2, 1 }
  pigment { rgb <1, 0.4, 0.2> } finish { specular 0.5 } }
