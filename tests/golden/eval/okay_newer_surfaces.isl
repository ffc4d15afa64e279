// Cameras, objects, pigments, finishes and lights in the words of 3.8.
#version 3.8;
camera {
  user_defined
  location { function { sin(x) }, function { y } function { -5 } }
  direction { function { u } function { v } function { 1 } }
}
camera { user_defined location <1, 2, 3> direction { function { x } function { y } function { 2 } } }
light_source { 0 rgb 1 fade_power 2 }
light_source { 0 rgb 1 fade_distance 3 fade_power 2 }
ovus { 1, 0.6 distance 1.5 radius 3 precision 1e-4 sturm }
ovus { 1, 0.6 radius 3 }
ovus { 1, 0 radius 1 }
ovus { 1, 3 distance 2 radius 4 }
#declare Two = blob { threshold 0.5 sphere { 0, 2, 1 } cylinder { x, 3*x, 1, -0.5 } }
sphere { 0, 1 pigment { potential { Two } threshold on color_map { [0 rgb 0] [1 rgb 1] } } }
sphere { 0, 1 pigment { potential { blob { Two scale 2 inverse } } ramp_wave frequency 2 } }
sphere { 0, 1 normal { potential { Two } 0.5 } finish { fresnel } }
sphere { 0, 1 pigment { user_defined { function { x }, , function { z }, , function { 0.5 } } scale 2 } }
sphere { 0, 1 pigment { user_defined { } } finish { fresnel 0.5 reflection 0.4 use_alpha } interior { ior 1.5 } }
sphere { 0, 1 finish { fresnel reflection { 0.1, 1 fresnel off } } }
sphere { 0, 1 pigment { image_map { png "a.png" transmit all 0.5 map_type 7 } } finish { reflection { 0.3 } fresnel } }
