// Urchins in a tide pool: purple, red and black ones, and a starfish between stones, under clear water that a little
// wind moves.
//   isl render scenes/gallery/tide_pool.isl
#version 3.7;
#include "growth.isl"
#include "random.isl"
#include "creatures.isl"
global_settings { assumed_gamma 1 max_trace_level 4 }

camera { location <0, 6.4, -3.9> look_at <0.1, 0, -0.05> angle 41 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.8, 0.85, 0.9>] [1 rgb <0.25, 0.42, 0.68>] } } }
light_source { <-7, 10, 5> rgb <1.4, 1.3, 1.1> }
light_source { <6, 8, -6> rgb <0.25, 0.32, 0.36> shadowless }

#declare Chance = Random_stream("pool", 2);
#macro Urchin(P, R, Body_colour, Spine_colour, Count)
  #macro Growth_paint(S) pigment { color (S > 0 ? Spine_colour : Body_colour) } #end
  blob {
    kernel "gaussian" hardness 6
    Growth_urchin(0, R, Count, 0.95*R, 0.055*R, Chance)
    finish { ambient 0.06 diffuse 0.75 specular 0.5 roughness 0.02 }
    rotate Random_between(-25, 25, Chance)*z
    translate P
  }
#end
Urchin(<-0.85, 0.1, 0.35>, 0.52, rgb <0.07, 0.02, 0.08>, rgb <0.32, 0.12, 0.42>, 420)
Urchin(<0.75, 0, 0.75>, 0.4, rgb <0.1, 0.02, 0.02>, rgb <0.6, 0.13, 0.1>, 340)
Urchin(<0.55, -0.05, -0.72>, 0.34, rgb <0.02, 0.02, 0.03>, rgb <0.07, 0.06, 0.11>, 320)
Urchin(<-0.45, -0.1, -0.95>, 0.24, rgb <0.1, 0.03, 0.08>, rgb <0.5, 0.28, 0.5>, 260)
Urchin(<1.65, 0, -0.25>, 0.27, rgb <0.07, 0.02, 0.08>, rgb <0.36, 0.14, 0.45>, 260)

#macro Creature_paint(P) pigment { rgb (P = "spine" ? <1, 0.62, 0.3> : <0.85, 0.27, 0.05>) } #end
blob {
  kernel "gaussian" hardness 4
  Creature_starfish(0, 0.55, 5, 11)
  finish { ambient 0.06 diffuse 0.75 specular 0.3 roughness 0.03 }
  rotate <-14, 20, 12> translate <1.0, -0.22, -1.25>
}

// The basin: stones that have been ground into one another.
blob {
  kernel "cubic" hardness 2
  plane { y, -0.5, 0.1 }
  #for (I, 0, 69)
    #local A = 360*I/70;
    #local Away = Random_between(1.9, 4.2, Chance);
    sphere { 0, Random_between(0.4, 0.8, Chance)
      scale <1, 0.7, 1>
      translate vrotate(<Away*1.15, -0.7 + 0.62*(Away - 1.6), 0>, A*y)
    }
  #end
  #for (I, 0, 130)
    sphere { Random_on_disc(-0.45*y, y, 2.6, Chance), Random_between(0.05, 0.2, Chance) }
  #end
  pigment {
    granite scale 1.3
    color_map { [0.1 rgb <0.06, 0.055, 0.05>] [0.5 rgb <0.2, 0.17, 0.14>] [0.8 rgb <0.3, 0.24, 0.19>] }
  }
  normal { granite 0.25 scale 0.5 }
  finish { ambient 0.05 diffuse 0.75 specular 0.1 roughness 0.05 }
}
// Water.
plane { y, 0.62
  pigment { rgbf <0.72, 0.93, 0.9, 0.96> }
  normal { ripples 0.07 turbulence 0.6 scale 0.9 translate <5, 0, 3> }
  finish { ambient 0 diffuse 0 specular 0.5 roughness 0.004 reflection { 0.02, 0.8 falloff 4 } }
  interior { ior 1.33 }
  no_shadow
}
