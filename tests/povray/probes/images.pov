// Images in functions: where each map type finds its pixels, what lies between them, palettes, numbers.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Say(Name, F)
  #debug concat(Name, "\n")
  #local S = seed(7);
  #for (I, 1, 20)
    #local X = 4*rand(S)-2; #local Y = 4*rand(S)-2; #local Z = 4*rand(S)-2;
    #local C = F(X,Y,Z);
    #debug concat(" ", str(C.red,0,5), " ", str(C.green,0,5), " ", str(C.blue,0,5))
    #debug concat(" ", str(C.filter,0,5), " ", str(C.transmit,0,5), "\n")
  #end
#end
#declare F = function { pigment { image_map { ppm "image.ppm" } } }
Say("planar", F)
#undef F
#declare F = function { pigment { image_map { ppm "image.ppm" once } } }
Say("once", F)
#undef F
#declare F = function { pigment { image_map { ppm "image.ppm" repeat <2, 3> offset <0.3, 0.1> } } }
Say("repeat", F)
#undef F
#declare F = function { pigment { image_map { ppm "image.ppm" map_type 1 } } }
Say("spherical", F)
#undef F
#declare F = function { pigment { image_map { ppm "image.ppm" map_type 2 } } }
Say("cylindrical", F)
#undef F
#declare F = function { pigment { image_map { ppm "image.ppm" map_type 2 once } } }
Say("cylindrical once", F)
#undef F
#declare F = function { pigment { image_map { ppm "image.ppm" map_type 5 } } }
Say("toroidal", F)
#undef F
#declare F = function { pigment { image_map { ppm "image.ppm" interpolate 2 } } }
Say("bilinear", F)
#undef F
#declare F = function { pigment { image_map { ppm "image.ppm" interpolate 3 } } }
Say("bicubic", F)
#undef F
#declare F = function { pigment { image_map { ppm "image.ppm" interpolate 4 } } }
Say("normalised distance", F)
#undef F
#declare F = function { pigment { image_map { ppm "image.ppm" interpolate 2 once } } }
Say("bilinear once", F)
#undef F
#declare F = function { pigment { image_map { ppm "image.ppm" filter all 0.3 transmit all 0.2 } } }
Say("transparent", F)
#undef F
#declare F = function { pigment { image_map { ppm "image.ppm" map_type 1 interpolate 3 } } }
Say("spherical bicubic", F)
#undef F
#declare F = function { pigment { image_map { ppm "image.ppm" gamma 2.2 } } }
Say("gamma", F)
#undef F
#declare F = function { pigment { image_map { ppm "image.ppm" gamma srgb } } }
Say("gamma srgb", F)
#undef F
#declare F = function { pigment { image_map { png "palette.png" } } }
Say("palette", F)
#undef F
#declare F = function { pigment { image_map { png "palette.png" filter 1, 0.5 transmit 2, 0.25 } } }
Say("numbers of a palette", F)
#undef F
#declare F = function { pigment { image_map { png "palette.png" transmit all 0.25 } } }
Say("all of a palette", F)
#undef F
#declare F = function { pigment { image_pattern { ppm "image.ppm" } color_map { [0 rgb 0] [1 rgb <1, 0.5, 0.25>] } } }
Say("values", F)
#undef F
#declare F = function { pigment { image_pattern { ppm "image.ppm" interpolate 2 } color_map { [0 rgb 0] [1 rgb <1, 0.5, 0.25>] } } }
Say("values between", F)
#undef F
#declare F = function { pigment { image_pattern { ppm "image.ppm" once } color_map { [0 rgb 0] [1 rgb <1, 0.5, 0.25>] } } }
Say("values once", F)
#undef F
#declare F = function { pigment { image_pattern { png "palette.png" use_index } color_map { [0 rgb 0] [1 rgb <1, 0.5, 0.25>] } } }
Say("values of a palette", F)
#undef F
#declare F = function { pigment { image_pattern { function 5, 4 { x*0.5 + y*0.3 } } color_map { [0 rgb 0] [1 rgb <1, 0.5, 0.25>] } } }
Say("values of a function", F)
#undef F
#declare F = function { pigment { image_pattern { function 5, 4 { x*0.5 + y*0.3 } interpolate 2 } color_map { [0 rgb 0] [1 rgb <1, 0.5, 0.25>] } } }
Say("values of a function between", F)
#undef F
