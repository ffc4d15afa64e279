// A component with a similarity baked in keeps its rotation for its coordinates; one that is not rotated has none.
global_settings { assumed_gamma 1 }
#declare Checks = pigment { uv_mapping checker rgb 0, rgb 1 scale 0.1 };
#declare Lines = texture { uv_mapping pigment { gradient x } };
blob {
  kernel "gaussian"
  sphere { x, 1 translate y scale 2 }
  sphere { x, 1 rotate 90*z pigment { Checks rotate 30*z } }
  blob {
    cylinder { 0, x, 0.2 rotate 90*y }
    cylinder { 0, x, 0.2 scale <2, 1, 1> }
    texture { Lines scale 2 }
    rotate 90*z
  }
  texture { uv_mapping pigment { gradient y } rotate 90*z }
}
light_source { 0, rgb 1 }
camera { location -5*z }
