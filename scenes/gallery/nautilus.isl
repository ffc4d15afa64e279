// A shell: one tube along a logarithmic spiral, its turns grown together, flamed in brown across each turn.
//   isl render scenes/gallery/nautilus.isl
#version 3.7;
#include "growth.isl"
global_settings { assumed_gamma 1 max_trace_level 3 }

camera { location <-0.6, 1.5, -6.4> look_at <0.16, 0.9, 0> angle 36 }
light_source { <-6, 6, -2> rgb <1.3, 1.16, 0.95> area_light 2*y, 2*z, 6, 6 jitter circular orient }
light_source { <7, 3, -6> rgb <0.16, 0.2, 0.3> shadowless }
light_source { <3, 4, 8> rgb <0.4, 0.42, 0.5> }
sky_sphere { pigment { gradient y
  color_map { [0 rgb <0.055, 0.065, 0.075>] [0.3 rgb <0.07, 0.08, 0.09>] [1 rgb <0.7, 0.72, 0.78>] } } }

#declare Pearl = finish {
  ambient 0.05 diffuse 0.72 specular 0.5 roughness 0.01
  irid { 0.12 thickness 0.4 turbulence 0.3 } reflection { 0.01, 0.35 falloff 4 }
}
#macro Growth_paint(S)
  pigment {
    #if (S > 0.96)
      rgb <0.95, 0.9, 0.82>
    #else
      // Flames: narrow bands over the tube.
      #local Band = pow(abs(sin(30*S*S*S + 10*S)), 5)*0.8;
      rgb <0.95, 0.9, 0.82> + (<0.42, 0.16, 0.06> - <0.95, 0.9, 0.82>)*min(1, 1.7*Band)
    #end
  }
#end
#declare Shell = difference {
  blob {
    kernel "gaussian" hardness 5
    Growth_shell(0, 1, 4, 2.6, 0, 0)
    finish { Pearl }
  }
  // The mouth.
  sphere { <1, 0, -0.24>, 0.4 pigment { rgb <0.96, 0.82, 0.72> } finish { Pearl } }
  rotate <-90, 0, 0>
  rotate <0, 22, 24>
}
object { Shell translate 0.765*y }
fog { distance 26 rgb <0.055, 0.065, 0.075> }
plane { y, 0
  pigment { rgb <0.075, 0.085, 0.095> }
  finish { ambient 0.05 diffuse 0.65 reflection { 0.01, 0.35 falloff 4 } }
}
