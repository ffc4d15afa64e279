// Pigments by patterns on solids and on a blob whose materials blend along: checker, gradient, marble, wood, crackle and bands of
// a color_map.
//   isl render scenes/features/patterns.isl -s 1000x500
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.4, -9> look_at <0, -0.1, 0> angle 52 right 2*x up y }
light_source { <6, 9, -8> rgb 0.95 }
light_source { <-8, 4, -5> rgb 0.3 shadowless }
background { rgb <0.85, 0.89, 0.93> }

#default { finish { ambient 0.15 diffuse 0.75 phong 0.3 phong_size 50 } }

plane { y, -1 pigment { checker rgb <0.82, 0.80, 0.76>, rgb <0.42, 0.45, 0.50> scale 0.6 } }

#declare Bands = color_map { [0 rgb <0.15, 0.25, 0.55>] [0.4 rgb <0.3, 0.65, 0.7>] [0.6 rgb <0.95, 0.85, 0.5>] [1 rgb <0.75, 0.25, 0.2>] }

sphere { 0, 0.8 pigment { marble turbulence 0.8 color_map { [0 rgb <0.95, 0.94, 0.92>] [0.7 rgb <0.6, 0.58, 0.56>] [1 rgb <0.15, 0.15, 0.2>] } scale 0.5 } translate <-3, -0.2, 0> }
box { -0.62, 0.62 pigment { wood turbulence 0.06 color_map { [0 rgb <0.72, 0.48, 0.28>] [1 rgb <0.42, 0.24, 0.12>] } scale 0.22 rotate <88, 4, 0> } rotate 35*y translate <-1.15, -0.38, 0.4> }
blob {
  kernel "gaussian" hardness 3
  sphere { <-0.45, 0, 0>, 0.6 pigment { gradient y color_map { Bands } scale 0.6 translate -0.3*y } }
  sphere { <0.55, 0.25, 0>, 0.5 pigment { crackle color_map { [0 rgb <0.1, 0.1, 0.12>] [0.12 rgb <0.85, 0.55, 0.25>] [1 rgb <0.95, 0.8, 0.5>] } scale 0.22 } }
  translate <1, -0.35, -0.3>
}
union {
  cylinder { -0.95*y, 0.5*y, 0.5 }
  sphere { 0.5*y, 0.5 }
  pigment { spiral1 3 color_map { Bands } rotate 90*x scale 0.4 }
  translate 3.2*x
}
