// Eggs: the ovus from its bottom sphere (left) to its top sphere, and as part of combinations and with patterns on its coordinates.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5.2, -11.5> look_at <0, 0.85, 0> angle 42 }
light_source { <-6, 10, -9> rgb 0.85 }
light_source { <8, 6, -7> rgb <0.22, 0.25, 0.32> }
background { rgb <0.05, 0.06, 0.09> }
#default { finish { ambient 0.12 diffuse 0.7 specular 0.4 roughness 0.02 } }

plane { y, 0 pigment { rgb 0.75 } finish { ambient 0.1 diffuse 0.6 specular 0 } }

#macro Shell(K) pigment { rgb <0.93, 0.84 - 0.12 * K, 0.70 - 0.22 * K> } #end

// ---- The whole family: the height is the same, the share of the top radius grows ---------------------------------------
#declare Tops = array[7] {0.03, 0.3, 0.6, 0.85, 1, 1.4, 1.9}
#for (I, 0, 6)
  #local Bottom = 1;
  #local Top = Tops[I];
  ovus { Bottom, Top translate Bottom * y scale 1.4 / (2 * Bottom + Top) Shell(I / 6) translate <1.25 * (I - 3), 0, 1.2> }
#end

// ---- Cut, combined, turned and painted ---------------------------------------------------------------------------------
#declare Egg = ovus { 0.6, 0.38 }
difference {
  object { Egg pigment { rgb <0.95, 0.93, 0.88> } }
  object { Egg scale 0.9 pigment { rgb <0.98, 0.97, 0.95> } }
  plane { z, 0 rotate 35 * y pigment { rgb <0.9, 0.88, 0.8> } }
  rotate -20 * z translate <-2.9, 0.62, -1.6>
}
intersection {
  object { Egg } object { Egg rotate 180 * z translate 0.55 * y }
  pigment { rgb <0.35, 0.55, 0.80> } translate <-1.1, 0.5, -1.6>
}
union {
  object { Egg rotate 90 * z } object { Egg rotate -90 * z }
  pigment { rgb <0.55, 0.75, 0.40> } rotate 25 * y translate <0.9, 0.6, -1.6>
}
ovus { 0.6, 0.42
  pigment { uv_mapping checker rgb <0.85, 0.25, 0.2>, rgb <0.95, 0.9, 0.75> scale <1 / 12, 1 / 8, 1> }
  rotate <-15, 40, 12> translate <2.9, 0.62, -1.6>
}
