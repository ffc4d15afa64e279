// Crown: a drop of milk has fallen into milk. The sheet that it throws up, the fingers into which the sheet breaks, the
// beads that pinch off them: one surface, a thousandth of a second old, on vermilion lacquer.
//   isl render scenes/gallery/crown.isl
#include "skies.isl"
#declare Chance = seed(9);
#macro Between(A, B) (A + (B - A) * rand(Chance)) #end
#macro Ring(R, H, A) vrotate(<R, H, 0>, A*y) #end
#declare N = 17;
#declare M = 320;
blob {
  kernel "gaussian" hardness 1.2
  disc { -0.03*y, y, 1.2, 0.06 }                                  // the pool, with bays
  #for (I, 0, 8) disc { Ring(Between(0.6, 0.9), -0.03, 40*I), y, Between(0.35, 0.75), 0.05 } #end
  kernel "quartic" hardness 1 convolution on
  #for (I, 0, M - 1) #local A = 360*I/M;                          // the sheet, opening like a bell
    #local W = 0.5 + 0.5*cos(N*radians(A));                       // it is highest under a finger
    cylinder { Ring(0.97, -0.02, A), Ring(0.96, 0.24, A), 0.034 }
    cylinder { Ring(0.96, 0.24, A), Ring(1.06 + 0.02*W, 0.5 + 0.08*W, A), 0.03 }
  #end
  convolution off
  kernel "gaussian" hardness 2
  torus { 0.97, 0.05 }                                            // its foot
  kernel "gaussian" hardness 3
  #for (I, 0, N - 1)
    #local A = 360*I/N + Between(-4, 4);
    #local L = pow(rand(Chance), 1.3);
    #local R = Ring(1.26 + 0.36*L, 0.74 + 0.5*L, A);
    cone { Ring(1.07, 0.53, A), 0.058, R, 0.03 }
    sphere { R, Between(0.06, 0.095) }
    #if (L > 0.35)                                                // a bead has just come off
      sphere { 0, Between(0.045, 0.075) scale <1, 1.1, 1> translate R + Ring(0.19 + 0.1*L, 0.24*L + 0.06, A) }
    #end
  #end
  sphere { 0, 0.17 scale <1, 1.08, 1> translate <0.03, 1.75, 0> }    // the next drop
  #for (I, 0, 16) sphere { 0, Between(0.03, 0.09) scale <1, 0.6, 1> translate Ring(Between(1.9, 3), -0.01, Between(0, 360)) } #end
  pigment { rgb <0.93, 0.9, 0.85> }
  finish { ambient 0.14 diffuse 0.8 specular 0.5 roughness 0.006 reflection { 0.01, 0.35 falloff 4 } }
}
plane { y, -0.03 pigment { rgb <0.55, 0.015, 0.01> } finish { ambient 0.1 diffuse 0.7 specular 0.3 roughness 0.02 reflection { 0.04, 0.6 falloff 5 } } }
sky_sphere { SkyGradient(rgb <0.2, 0.01, 0.01>, rgb <0.2, 0.01, 0.01>, rgb <0.8, 0.7, 0.65>) SkyPanel(<-1, 0.9, -0.6>, 50, 40, rgb 3) }
fog { distance 14 rgb <0.06, 0.003, 0.003> }
light_source { <-6, 8, -2.5> rgb <1.4, 1.33, 1.2> area_light 3*x, 3*z, 8, 8 circular orient jitter }
light_source { <1, -6, -4> rgb <0.3, 0.03, 0.02> shadowless }
light_source { <5, 5, 7> rgb <0.3, 0.32, 0.4> shadowless }
camera { location <0, 2.5, -6.2> look_at <0.0, 0.72, 0> angle 37 }
