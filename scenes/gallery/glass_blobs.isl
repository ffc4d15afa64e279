// Glass blobs: three drops of coloured glass that have run together, and the light that has gone through them.
//   isl render scenes/gallery/glass_blobs.isl
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0.04 }

camera { location <0.4, 2.9, -6.8> look_at <0.1, 0.5, 0> angle 36 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.75, 0.72, 0.7>] [0.4 rgb <0.55, 0.6, 0.68>] [0.7 rgb 1.1] } } }
light_source { <-4, 7, 5> rgb <1.2, 1.12, 1> }
light_source { <5, 6, -6> rgb <0.25, 0.27, 0.32> shadowless }

#macro Tint(C) texture { pigment { rgbf <C.x, C.y, C.z, 0.97> }
  finish { ambient 0 diffuse 0.02 specular 1 roughness 0.002 reflection { 0, 0.7 falloff 5 } } } #end
#declare Amber = <1, 0.55, 0.12>;
#declare Rose = <1, 0.3, 0.42>;
#declare Sea = <0.25, 0.8, 0.85>;
blob {
  kernel "gaussian" hardness 2
  sphere { <-1.0, 0.5, 0.1>, 0.52 Tint(Sea) }
  sphere { <0.12, 0.62, -0.2>, 0.6 Tint(Rose) }
  sphere { <1.1, 0.42, 0.12>, 0.44 Tint(Amber) }
  sphere { <0.55, 1.25, 0.1>, 0.26 Tint(Amber) }
  sphere { <-0.5, 1.08, 0.2>, 0.22 Tint(Sea) }
  sphere { <1.72, 0.2, -0.28>, 0.19 Tint(Amber) }
  // A bubble in the middle one.
  kernel "cubic" hardness 4
  sphere { <0.05, 0.6, -0.25>, 0.22 strength -1.6 Tint(Rose) }
  interior { ior 1.35 caustics 0.9 }
}
sphere { <-1.75, 0.16, -0.75>, 0.16 Tint(Sea) interior { ior 1.35 caustics 0.9 } }
plane { y, 0 pigment { rgb <0.88, 0.86, 0.84> } finish { ambient 0.12 diffuse 0.7 reflection { 0, 0.2 falloff 4 } } }
