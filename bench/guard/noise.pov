// Noise in everything: pigments, warps, normals, a sky.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at <0, 0.8, 0> angle 50 }
light_source { <10, 20, -15>, 1 }
sky_sphere { pigment { bozo turbulence 0.7 octaves 6 color_map { [0 rgb <0.3, 0.5, 0.9>] [1 rgb 1] } scale 0.3 } }
plane { y, 0
  pigment { wood turbulence 0.1 color_map { [0 rgb <0.7, 0.4, 0.2>] [1 rgb <0.4, 0.2, 0.1>] } scale 0.4 rotate 4 * x }
  normal { bumps 0.3 scale 0.2 }
}
sphere { <-2, 1, 0>, 1 pigment { granite color_map { [0 rgb 0.2] [1 rgb 0.9] } } normal { wrinkles 0.5 scale 0.3 } }
sphere { <0, 1, 1>, 1 pigment { agate color_map { [0 rgb <0.9, 0.7, 0.5>] [1 rgb <0.4, 0.2, 0.2>] } } }
sphere { <2, 1, 0>, 1
  pigment { marble warp { turbulence 0.6 octaves 5 } color_map { [0 rgb 1] [1 rgb <0.1, 0.2, 0.3>] } }
  finish { specular 0.5 }
}
