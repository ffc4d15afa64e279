// Functions of patterns and pigments: called while the scene is read, and kept for what is textured with them.
#declare Clouds = function { pattern { bozo turbulence 0.5 octaves 4 scale 0.3 } }
#declare Stone = function { pigment { granite color_map { [0 rgb 0] [1 rgb <1, 0.5, 0.25>] } scale 2 } }
#debug concat("clouds ", str(Clouds(0.1, 0.2, 0.3), 0, 9), "\n")
#debug concat("stone ", vstr(3, Stone(0.1, 0.2, 0.3), " ", 0, 6), "\n")
#declare Unused = pigment { wood scale 7 }
#declare Both = function (x, y, z) { Clouds(x, y, z) + Stone(x, y, z).gray }
sphere { 0, 1 pigment { function { Both(x, 2*y, z) } color_map { [0 rgb 0] [1 rgb 1] } rotate 30*y } }
sphere { 0, 1 pigment { image_map { function 16, 8 { pigment { checker scale 0.25 } } } } }
