// One macro of plain solids, twice: in a `union`, where every solid is itself, and in a `blob` with a kernel in force, where the
// same solids are skeletons that melt into one another. So models are made as solids and blended when they are right.
//   isl render scenes/features/one_macro_two_models.isl -s 900x420
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.6, -9.5> look_at <0.1, 0, 0> angle 44 right 900/420*x up y }
light_source { <5, 9, -7> rgb 0.95 }
light_source { <-7, 3, -5> rgb 0.28 shadowless }
background { rgb <0.88, 0.90, 0.88> }

// A crab's leg of two parts, its joints and its foot.
#macro Leg()
  sphere { <-1.3, -0.2, 0>, 0.45 }
  cylinder { <-1.3, -0.2, 0>, <0.1, 0.75, 0>, 0.22 }
  sphere { <0.1, 0.75, 0>, 0.27 }
  cone { <0.1, 0.75, 0>, 0.2, <1.45, -0.8, 0>, 0.07 }
#end

#declare Look = texture { pigment { rgb <0.83, 0.45, 0.28> } finish { ambient 0.15 diffuse 0.75 phong 0.4 phong_size 50 } }
union { Leg() texture { Look } translate -1.8 * x }
blob { kernel "quartic" hardness 2.5 Leg() texture { Look } translate 1.9 * x }
plane { y, -0.9 pigment { rgb <0.70, 0.74, 0.70> } finish { ambient 0.2 diffuse 0.7 } }
