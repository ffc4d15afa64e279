// The cross (Sherstyuk 1999, section 3): two crossed segments, the paper's test of how well few interpolants follow a field.
// From the front the published solver looks right, from the side it does not:
//   isl render scenes/paper/cross.isl -s 400x400 --solver paper
//   isl render scenes/paper/cross.isl -s 400x400 --solver paper -D Side=1
//   isl render scenes/paper/cross.isl -s 400x400 -D Side=1
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Side) #declare Side = 0; #end

camera { location (Side ? <-7, 0.6, 0.35> : <0, 0, -7>) look_at 0 angle 32 right x up y }
light_source { <-6, 8, -9> rgb 0.95 }
light_source { <-8, -3, 6> rgb 0.25 shadowless }
background { rgb <0.92, 0.92, 0.90> }

blob {
  kernel "gaussian" hardness 4
  cylinder { <-1.2, -1.2, 0>, <1.2, 1.2, 0>, 0.3 }
  cylinder { <-1.2, 1.2, 0>, <1.2, -1.2, 0>, 0.3 }
  pigment { rgb <0.85, 0.52, 0.26> }
  finish { ambient 0.12 diffuse 0.75 phong 0.5 phong_size 60 }
}
