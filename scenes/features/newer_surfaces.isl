// Words of POV-Ray 3.8 on surfaces and before them: a finish with `fresnel`, paint that ends with its gloss, colours by functions, the field of
// a blob as a pattern, eggs with controls, light that fades from its point, and a camera that is a function.
#version 3.8;
global_settings { assumed_gamma 1 }

// A camera that moves along an arc as it looks to the side, so that the row is seen from the front everywhere.
camera {
  user_defined
  location { function { 7*sin(x/2) } function { 2 } function { 1.5 - 8*cos(x/2) } }
  direction { function { sin(x*0.8) } function { y*0.48 - 0.13 } function { cos(x*0.8) } }
}
light_source { <-4, 7, -5>, rgb 90 fade_power 2 }
light_source { <7, 4, -6>, rgb <0.35, 0.4, 0.5> shadowless }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.8, 0.84, 0.9>] [0.6 rgb <0.3, 0.42, 0.62>] } } }

plane { y, 0
  pigment { user_defined { function { 0.42 + 0.12*sin(x*3)*sin(z*3) } function { 0.36 + 0.1*sin(x*3)*sin(z*3) } function { 0.3 } } }
  finish { diffuse 0.8 }
}

// Lacquer: what its surface mirrors, the wood below does not get.
ovus { 0.75, 0.45 distance 0.9 radius 2.2
  pigment { wood turbulence 0.06 scale 0.35 rotate 80*x color_map { [0 rgb <0.5, 0.26, 0.12>] [1 rgb <0.26, 0.1, 0.04>] } }
  finish { fresnel diffuse 0.9 specular albedo 0.8 roughness 0.004 reflection 1 }
  interior { ior 1.6 }
  translate <-3, 0.75, 0>
}

// Gloss paint on a clear sheet: where there is no paint, there is no gloss.
box { <-0.85, 0, -0.02>, <0.85, 1.9, 0.02>
  pigment { user_defined { function { 0.8 } function { 0.1 } function { 0.08 } , , function { select(sin(x*9)*sin(y*9) - 0.2, 1, 1, 0) } } }
  finish { diffuse 0.7 phong 0.9 phong_size 30 reflection 0.25 use_alpha }
  rotate 25*y translate <-0.9, 0, 0.3>
}

// The field of a blob in its own colours, on a ball that it reaches through.
#declare Three = blob {
  threshold 0.4
  sphere { <0.5, 0.4, -0.6>, 1.1, 1 }
  sphere { <-0.5, 0.3, -0.7>, 0.9, 1 }
  sphere { <0, -0.5, -0.8>, 0.8, -0.8 }
}
sphere { 0, 1
  pigment { potential { Three } color_map { [-0.4 rgb <0.1, 0.2, 0.6>] [0 rgb 0.85] [0.4 rgb <1, 0.8, 0.2>] [0.9 rgb <0.8, 0.15, 0.1>] } }
  finish { diffuse 0.8 phong 0.3 }
  translate <1.3, 1, 0>
}
ovus { 0.55, 0.85 distance 0.75 radius 1.6 pigment { rgb <0.55, 0.7, 0.6> } finish { diffuse 0.85 } translate <3.3, 0.55, 0.2> }
