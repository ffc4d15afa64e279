#default { finish { ambient 0 diffuse 1 } }
#declare P = pigment { rgbt <1, 1, 1, .5> }
#declare F = finish { phong .5 phong_size 10 }
#declare T = texture { pigment { P } finish { F specular 1 roughness .1 } }
sphere { 0, 1 }
sphere { 0, 1 texture { T } }
sphere { 0, 1 texture { T pigment { color red 1 } } }
sphere { 0, 1 pigment { P } finish { F } }
