// Normals bent by patterns: hammered metal, ripples on water, quilted cloth, dented and wrinkled balls.
//   isl render scenes/features/bumps.isl -s 1000x500
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 4.6, -9.5> look_at <0, 0.5, 0> angle 60 right 2*x up y }
light_source { <-6, 8, -5> rgb 1 }
light_source { <7, 3, -6> rgb <0.25, 0.22, 0.3> shadowless }
background { rgb <0.08, 0.1, 0.16> }

plane {
  y, -0.15
  pigment { rgb <0.05, 0.12, 0.2> }
  normal { ripples 0.35 frequency 3 scale 1.6 translate <2, 0, -1> }
  finish { ambient 0 diffuse 0.4 specular 0.6 roughness 0.01 reflection 0.35 }
}

#macro Ball(X, Colour, Shine)
  sphere { <X, 0.9, 0>, 0.85 pigment { rgb Colour } finish { ambient 0.03 diffuse 0.6 specular Shine roughness 0.02 } }
#end

object { Ball(-3.8, <0.9, 0.62, 0.3>, 0.9) normal { facets size 0.14 } finish { diffuse 0.25 metallic reflection { 0.4 metallic } } }
object { Ball(-1.9, <0.75, 0.2, 0.25>, 0.3) normal { quilted 0.9 control0 0.6 control1 0.9 scale 0.28 } }
object { Ball(0, <0.35, 0.6, 0.35>, 0.5) normal { wrinkles 0.8 scale 0.35 } }
object { Ball(1.9, <0.6, 0.62, 0.68>, 0.9) normal { dents 1.2 scale 0.16 } finish { diffuse 0.3 metallic reflection 0.3 } }
object {
  Ball(3.8, <0.85, 0.8, 0.7>, 0.6)
  // A screw: a profile of slopes on a spiral.
  normal { spiral1 3 1 slope_map { [0 <0, 1>] [0.5 <1, 1>] [0.5 <1, -1>] [1 <0, -1>] } rotate 90*x scale 0.3 translate <3.8, 0, 0> }
}
