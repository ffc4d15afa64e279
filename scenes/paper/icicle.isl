// The icicle (Sherstyuk 1999, Figure 1): three segments and a point, of one soft kernel, melt into one drop of ice.
//   isl render scenes/paper/icicle.isl -s 480x640
//   isl render scenes/paper/icicle.isl -s 480x640 --skeleton
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 0.2, -9> look_at <0, 0.2, 0> angle 32 right 0.75*x up y }
light_source { <5, 7, -6> rgb 0.95 }
light_source { <-6, 2, -5> rgb <0.30, 0.36, 0.45> shadowless }
background { rgb <0.16, 0.20, 0.28> }

blob {
  kernel "gaussian" hardness 1.2
  cylinder { <-1.05, 1.75, 0>, <1.05, 1.75, 0>, 0.34 }   // the eave
  cylinder { <0, 1.5, 0>, <0, 0.2, 0>, 0.30 }
  cylinder { <0, 0.1, 0>, <0, -1.25, 0>, 0.15 }
  sphere { <0, -1.62, 0>, 0.20 }                          // the drop
  pigment { rgb <0.72, 0.84, 0.95> }
  finish { ambient 0.12 diffuse 0.65 phong 0.9 phong_size 90 }
}
