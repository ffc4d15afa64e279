// Controlled blending: the legs of a union do not melt into one another, however they cross, and each grows out of the body;
// the ground is a half-space of the same blob, out of which a stone rises.
//   isl render scenes/features/blob_parts.isl -s 1000x560
//   isl render scenes/features/blob_parts.isl --skeleton -s 1000x560
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0.5, 4.6, -10.5> look_at <0, -0.35, 0> angle 38 right 1000/560*x up y }
light_source { <7, 11, -7> rgb 0.95 }
light_source { <-9, 5, -5> rgb 0.3 shadowless }
background { rgb <0.80, 0.86, 0.92> }

// A thigh that rises and a shin that comes down: turned by Turn, and forward by Lean at the hip.
#macro Leg(Turn, Lean)
  blob {
    cylinder { 0, <1.35, 0.75, 0>, 0.15 }
    cone { <1.35, 0.75, 0>, 0.15, <2.5, -0.95, 0>, 0.055 }
    rotate Lean * x
    rotate Turn * y
    pigment { rgb <0.93, 0.55, 0.30> }
  }
#end

blob {
  kernel "quartic" hardness 4
  sphere { <0, 0, 0>, 0.75 }
  sphere { <0, 0.25, -0.75>, 0.4 }
  plane { y, -1.12, 0.1 pigment { rgb <0.62, 0.68, 0.55> } }
  sphere { <-2.7, -1.0, -1.9>, 0.4 pigment { rgb <0.50, 0.52, 0.56> } }
  sphere { <-2.35, -1.05, -2.3>, 0.25 pigment { rgb <0.50, 0.52, 0.56> } }
  union {
    Leg(-24, 14) Leg(6, -8) Leg(36, 10) Leg(62, -6)
    Leg(204, -14) Leg(174, 8) Leg(144, -10) Leg(118, 6)
    // Two feelers that cross in front.
    blob { cone { <-0.2, 0.4, -0.95>, 0.09, <0.9, 0.75, -2.1>, 0.035 } pigment { rgb <0.75, 0.25, 0.30> } }
    blob { cone { <0.2, 0.4, -0.95>, 0.09, <-0.9, 0.72, -2.1>, 0.035 } pigment { rgb <0.35, 0.30, 0.70> } }
  }
  pigment { rgb <0.85, 0.30, 0.25> }
  finish { ambient 0.15 diffuse 0.75 phong 0.35 phong_size 50 }
}
