// Textures made of textures: layers that let what is below shine through, textures chosen by a pattern from place to place, an
// average of three, and the inside of an object as a pattern.
//   isl render scenes/features/layers.isl -s 1200x500
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 3.2, -13> look_at <0, -0.15, 0> angle 50 right 2.4*x up y }
light_source { <6, 9, -8> rgb 0.95 }
light_source { <-8, 3, -6> rgb 0.25 shadowless }
background { rgb <0.93, 0.91, 0.87> }
#default { finish { ambient 0.12 diffuse 0.75 } }

plane { y, -1.1 pigment { rgb <0.72, 0.70, 0.66> } }

#declare Glaze = texture { pigment { rgb <0.10, 0.32, 0.36> } finish { phong 0.8 phong_size 80 } }
#declare Clay = texture { pigment { granite color_map { [0 rgb <0.62, 0.30, 0.18>] [1 rgb <0.80, 0.50, 0.34>] } scale 0.6 } }
#declare Gold = texture { pigment { rgb <0.90, 0.62, 0.20> } finish { ambient 0.2 specular 0.8 roughness 0.03 } }

// Three layers: marble, a stain that filters it, and thin lines on top.
sphere { 0, 1.05
  texture { pigment { marble turbulence 0.7 color_map { [0 rgb <0.95, 0.93, 0.90>] [1 rgb <0.55, 0.52, 0.50>] } scale 0.5 } finish { phong 0.5 } }
  texture { pigment { bozo color_map { [0.4 rgbt 1] [0.7 rgbf <0.30, 0.62, 0.50, 0.85>] } scale 0.7 } }
  texture { pigment { uv_mapping gradient y color_map { [0.12 rgb <0.75, 0.20, 0.15>] [0.12 rgbt 1] } scale 1/9 } }
  rotate <-15, 0, -20> translate -4.6*x
}

// Glaze that has run down over the clay, with a soft border.
cylinder { -1.1*y, 0.95*y, 0.85
  texture {
    gradient y turbulence 0.25 omega 0.6
    texture_map { [0.45 Clay] [0.50 Glaze] }
    scale 2.1 translate -1.1*y
  }
  translate <-2.1, 0, 0.3>
}

// What lies inside the other object is of gold.
#declare Holes = union {
  #for (I, 0, 5) sphere { 0.95*x, 0.36 rotate 60*I*y } #end
  sphere { y, 0.5 }
}
sphere { 0, 1
  texture { object { Holes texture { Glaze } texture { Gold } } }
  rotate <-32, 12, 0> translate <0.3, -0.05, 0>
}

// The mean of three textures, weighted.
box { -0.78, 0.78
  texture { average texture_map { [2 Clay] [1 checker texture { Glaze } texture { Gold } scale 0.39] [1 pigment { wood color_map { [0 rgb 1] [1 rgb <0.3, 0.2, 0.1>] } scale 0.3 }] } }
  rotate 28*y translate <2.5, -0.32, 0>
}

// In a blob everything melts into one another: a chosen texture on the left, layers on the right.
blob {
  threshold 0.5
  sphere { -0.55*x, 1.1, 1 texture { brick texture { Clay } texture { Gold } scale 0.06 } }
  sphere { 0.6*x, 1.1, 1 texture { Gold } texture { pigment { crackle color_map { [0.1 rgb <0.10, 0.10, 0.12>] [0.2 rgbf <0.9, 0.5, 0.6, 0.8>] } scale 0.35 } } }
  rotate 24*z translate <4.75, -0.1, 0>
}
