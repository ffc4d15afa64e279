#declare Glass = interior { ior 1.5 caustics 0.3 dispersion 1.02 dispersion_samples 10 }
#declare Tint = interior { Glass fade_distance 2 fade_power 1001 fade_color rgb <0, 1, 0> }
#declare M = material { texture { pigment { rgbf 1 } } interior { Glass } }
#declare Striped = material { texture { pigment { gradient x } } scale 2 interior { Tint } interior_texture { pigment { onion } } translate x }
sphere { 0, 1 interior { Glass } }
sphere { 0, 1 interior { ior 1.5 caustics 0.3 dispersion 1.02 dispersion_samples 10 } }
sphere { 0, 1 material { M } interior { Tint } }
sphere { 0, 1 texture { pigment { wood } } material { M } }
sphere { 0, 1 material { Striped rotate 90*y } }
sphere { 0, 1 pigment { rgb 1 } interior_texture { pigment { rgb x } } }
sphere { 0, 1 pigment { rgbf 1 } finish { ior 1.2 caustics 1 } }
