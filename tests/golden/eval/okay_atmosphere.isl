#declare Sky = sky_sphere { pigment { gradient y color_map { [0 rgb 1] [1 rgb z] } scale 2 } }
sky_sphere { Sky pigment { bozo color_map { [0 rgbt 1] [1 rgb 1] } } emission 2 rotate 90*x rotate 90*y }
#declare Haze = fog { distance 100 color rgbft <0.5, 0.6, 0.7, 0.1, 0.2> }
fog { Haze distance 50 }
fog { fog_type 2 rgb 1 distance 20 fog_offset 1 fog_alt 2 turbulence 0.3 octaves 3 omega 0.4 lambda 1.5 turb_depth 0.2 up <0, 2, 0> rotate 90*z }
#declare Bow = rainbow { direction <0, 0, 2> angle 42.5 width 5 distance 1000 jitter 0.01 color_map { [0 rgbt 1] [1 rgb 1] } }
rainbow { Bow up <0, 1, 1> arc_angle 120 falloff_angle 30 }
