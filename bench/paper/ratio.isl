// Two balls that touch, one Ratio times as large as the other, seen so near that the small one fills the picture: for crab.sh.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Ratio) #declare Ratio = 100; #end
#declare Small = 1 / Ratio;

camera { location <1 + Small, 0.3 * Small, -6 * Small> look_at <1 + Small, 0, 0> angle 40 right x up y }
blob {
  kernel "gaussian" hardness 4
  sphere { 0, 1 }
  sphere { <1 + Small, 0, 0>, Small }
  pigment { rgb 1 }
}
