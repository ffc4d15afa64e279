// Mirrors and glass: balls that show one another over a chequered floor.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 3, -9> look_at <0, 0.8, 0> angle 45 }
light_source { <10, 20, -15>, 1 }
light_source { <-10, 10, -10>, 0.3 }
background { rgb <0.4, 0.6, 0.9> }
plane { y, 0 pigment { checker rgb 0.9 rgb 0.2 } finish { reflection 0.1 } }
#for (I, 0, 8)
  sphere { <mod(I, 3) * 2.1 - 2.1, 0.9, div(I, 3) * 2.1 - 2.1>, 0.9
    #if (mod(I, 2) = 0)
      pigment { rgb <0.5, 0.5, 0.55> }
      finish { diffuse 0.3 specular 0.6 reflection { 0.6 } }
    #else
      pigment { rgbf <0.9, 1, 0.95, 0.9> }
      finish { diffuse 0.1 specular 0.6 reflection { 0.02, 0.9 fresnel } conserve_energy }
      interior { ior 1.5 }
    #end
  }
#end
