#declare Checked = texture { checker texture { pigment { rgb 1 } } texture { pigment { rgb 0 } } }
sphere { 0, 1 texture { pigment { rgb 1 } } texture { Checked } }
sphere { 0, 1 texture { Checked } texture { pigment { rgbt 1 } } }
sphere { 0, 1 texture { Checked } finish { phong 1 } }
sphere { 0, 1 texture { Checked pigment { rgb 1 } } }
sphere { 0, 1 texture { finish { phong 1 } gradient x } }
sphere { 0, 1 texture { material_map { png "a.png" } } }
sphere { 0, 1 interior_texture { pigment { rgb 1 } } }
sphere { 0, 1 material { pigment { rgb 1 } } }
sphere { 0, 1 interior { dispersion_samples 1 } }
sphere { 0, 1 interior { pigment { rgb 1 } } }
sphere { 0, 1 finish { phnog 1 } }
sphere { 0, 1 finish { reflection { 0.5 fresnle } } }
sphere { 0, 1 finish { irid { thickness 1 } } }
#default { texture { Checked } }
sphere { 0, 1 normal { Checked } }
sphere { 0, 1 texture { pigment { rgb 1 } } uv_mapping }
