#declare F = finish { ambient rgb <0.1, 0.2, 0.3> diffuse 0.5 }
#declare Shiny = finish { F phong albedo 0.5 phong_size 60 specular albedo 0.2 roughness 0.01 metallic }
sphere { 0, 1 finish { F } }
sphere { 0, 1 finish { Shiny } }
sphere { 0, 1 finish { diffuse albedo 0.4, 0.2 brilliance 2 crand 0.1 conserve_energy use_alpha on } }
sphere { 0, 1 finish { diffuse 0.5 0.25 emission rgb 2 metallic 0.5 } }
sphere { 0, 1 finish { reflection 0.3 reflection_exponent 2 } }
sphere { 0, 1 finish { reflection rgb <1, 0.5, 0> } }
sphere { 0, 1 finish { reflection { 0.5 } } }
sphere { 0, 1 finish { reflection { 0.1, 0.9 fresnel on falloff 3 exponent 2 metallic 0.7 } } }
sphere { 0, 1 finish { reflection { rgb 0 rgb 1 metallic } irid { 0.3 thickness 0.2 turbulence 0.1 } } }
sphere { 0, 1 finish { Shiny } }
