// Light that passes: a blob of water, glass with a bubble, a thick slab that colours what is behind it, and their shadows.
//   isl render scenes/features/glass.isl -s 1000x500
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }

camera { location <0, 2.8, -8.4> look_at <0, 0.75, 0> angle 56 right 2*x up y }
light_source { <6, 9, -3> rgb 1.1 }
light_source { <-7, 4, -6> rgb <0.18, 0.2, 0.26> shadowless }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.96, 0.9, 0.82>] [0.35 rgb <0.55, 0.7, 0.88>] [1 rgb <0.12, 0.25, 0.5>] } }
}

plane {
  y, 0
  pigment { checker rgb <0.86, 0.83, 0.78> rgb <0.42, 0.45, 0.5> scale 0.7 }
  finish { ambient 0.05 diffuse 0.75 }
}

// What mirrors at the edge is missing behind it.
#declare Polish = finish { ambient 0 diffuse 0 specular 0.8 roughness 0.003 reflection { 0, 1 fresnel } conserve_energy }

#declare Water = material {
  texture { pigment { rgbf <0.93, 0.98, 1, 0.98> } finish { Polish } }
  interior { ior 1.33 fade_distance 1.5 fade_power 1001 fade_color <0.5, 0.85, 0.95> caustics 0.4 }
}
blob {
  threshold 0.5
  sphere { <0, 0.55, 0>, 1.1, 1 }
  sphere { <0.95, 0.5, -0.35>, 0.85, 1 }
  sphere { <-0.8, 0.45, 0.25>, 0.8, 1 }
  sphere { <0.25, 1.35, 0.1>, 0.75, 1 }
  material { Water }
  translate <-0.1, 0, -0.2>
}

// A ball of glass with a bubble of air.
union {
  sphere { 0, 1 material { texture { pigment { rgbf <1, 0.98, 0.97, 0.97> } finish { Polish } } interior { ior 1.5 } } }
  sphere { <0.1, 0.15, -0.1>, 0.45 material { texture { pigment { rgbf 1 } finish { Polish } } interior { ior 1 } } }
  translate <-2.9, 1, 0.6>
}

// A slab, whose colour grows with the way through it.
box {
  <-0.55, 0, -0.9>, <0.55, 2.1, 0.9>
  material {
    texture { pigment { rgbf <1, 1, 1, 0.98> } finish { Polish } normal { bumps 0.02 scale 0.25 } }
    interior { ior 1.52 fade_distance 0.5 fade_power 1001 fade_color <0.9, 0.45, 0.25> caustics 0.3 }
  }
  rotate 38*y
  translate <2.8, 0, 0.7>
}

// Things to see through it all.
#for (I, -9, 9)
  sphere { <0.62 * I, 0.26, 3.2>, 0.26 pigment { rgb <0.55 + 0.4 * sin(I), 0.5 + 0.35 * sin(2.1 + 1.3 * I), 0.35> } }
#end
