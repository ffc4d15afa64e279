#declare Moved = pigment { bozo turbulence <1, 2, 3> octaves 20 omega 0.3 lambda 3 scale 2 rotate 90*z }
sphere { 0, 1 pigment { Moved translate x } }  // one transform more
sphere { 0, 1 pigment { Moved } }
sphere { 0, 1 pigment { gradient x scale 2 warp { repeat -2*y offset x flip <1, 0, 2> } translate y scale 3
  warp { turbulence 0.5 octaves 3 } warp { black_hole <1, 2, 3>, 0.5 falloff 1 strength 2 inverse repeat 4 turbulence 0.1 } } }
sphere { 0, 1 pigment { onion warp { cylindrical orientation y dist_exp 1 } warp { spherical } warp { planar y, 2 }
  warp { toroidal major_radius 2 } warp { cubic } warp { planar } } }
sphere { 0, 1 pigment { wood sine_wave } }
sphere { 0, 1 pigment { wood poly_wave 2 frequency 3 phase 0.25 } }
sphere { 0, 1 pigment { uv_mapping leopard scallop_wave quick_color rgb x } }
sphere { 0, 1 pigment { rgb 1 quick_colour rgb x translate 5 } }
sphere { 0, 1 pigment { rgb 1 turbulence 3 frequency 2 scale 4 } }  // a plain colour, wherever
