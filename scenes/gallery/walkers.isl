// Square: seven figures cross the same empty place, each for himself; but all are grown of the one slab of bronze on
// which they walk. Thin limbs, and lumps of clay that a thumb has pressed to them, in one blob. After Giacometti.
//   isl render scenes/gallery/walkers.isl
#include "skies.isl"
#include "finishes.isl"
#declare Chance = seed(12);
#macro Between(A, B) (A + (B - A) * rand(Chance)) #end
#macro Limb(A, RA, B, RB, Lumps)
  cone { A, RA, B, RB }
  #for (J, 1, Lumps)
    #local T = rand(Chance);
    #local R = RA + (RB - RA)*T;
    sphere { 0, R*Between(0.6, 1) scale <1, Between(1, 2.2), 1>
      translate A + T*(B - A) + R*<Between(-0.8, 0.8), 0, Between(-0.8, 0.8)> }
  #end
#end
#macro Walker(Place, Turn, Stride, Tall)
  blob {
    #local Hip = <0, 1.42, 0>;  #local Chest = <0.12, 2.1, 0>;  #local Head = <0.26, 2.72, 0>;
    #local Front = <Stride, 0.03, 0.09>;  #local Back = <-1.1*Stride, 0.03, -0.09>;
    #local Knee = <0.62*Stride + 0.06, 0.75, 0.1>;  #local Bent = <-0.35*Stride, 0.72, -0.1>;
    Limb(Hip + 0.07*z, 0.07, Knee, 0.05, 6)  Limb(Knee, 0.05, Front, 0.045, 6)
    Limb(Hip - 0.07*z, 0.07, Bent, 0.05, 6)  Limb(Bent, 0.05, Back, 0.045, 6)
    Limb(Front, 0.07, Front + 0.2*x, 0.05, 2) Limb(Back - 0.05*x + 0.05*y, 0.05, Back + 0.16*x, 0.06, 2)
    Limb(Hip, 0.085, Chest, 0.1, 12)  Limb(Chest - 0.13*z, 0.07, Chest + 0.13*z, 0.07, 5)
    Limb(Chest, 0.08, Head - 0.18*y, 0.045, 4)
    Limb(Head - 0.1*y, 0.06, Head + <0.03, 0.06, 0>, 0.075, 5)  cone { Head, 0.04, Head + 0.11*x - 0.02*y, 0.02 }
    Limb(Chest + 0.15*z, 0.05, <-0.1 - 0.3*Stride, 1.68, 0.24>, 0.035, 5)
    Limb(<-0.1 - 0.3*Stride, 1.68, 0.24>, 0.035, <0.02 - 0.2*Stride, 1.22, 0.2>, 0.025, 4)
    Limb(Chest - 0.15*z, 0.05, <0.12 + 0.25*Stride, 1.66, -0.24>, 0.035, 5)
    Limb(<0.12 + 0.25*Stride, 1.66, -0.24>, 0.035, <0.3 + 0.4*Stride, 1.26, -0.18>, 0.025, 4)
    scale Tall rotate Turn*y translate Place
  }
#end
blob {
  kernel "gaussian" hardness 4
  plane { y, -0.06, 0.06 }
  Walker(<-2.7, 0, -1>, -12, 0.5, 1)
  Walker(<2.4, 0, -1.6>, 165, 0.55, 1.02)
  Walker(<-0.9, 0, 0.8>, 60, 0.4, 0.96)
  Walker(<1.3, 0, 2.4>, 195, 0.5, 1)
  Walker(<-2.5, 0, 4>, 30, 0.45, 0.98)
  Walker(<4.1, 0, 8>, 150, 0.4, 1)
  Walker(<0.6, 0, 9>, 10, 0.5, 1)
  pigment { bozo turbulence 0.5 color_map { [0 rgb <0.1, 0.06, 0.035>] [0.7 rgb <0.17, 0.11, 0.065>] [1 rgb <0.2, 0.22, 0.17>] } scale 0.3 }
  normal { bumps 0.35 scale 0.035 }
  finish { diffuse 0.8 specular 0.5 roughness 0.05 }
}
sky_sphere { SkyGradient(rgb <0.3, 0.2, 0.15>, rgb <1.0, 0.42, 0.13>, rgb <0.1, 0.17, 0.32>) }
fog { fog_type 2 fog_offset 0 fog_alt 0.9 distance 40 rgb <0.85, 0.4, 0.15> }
disc { <1.2, 2.9, 60>, -z, 4.2 no_shadow pigment { rgb <1, 0.75, 0.45> } finish { ambient 0 diffuse 0 emission 1.4 } }
light_source { <3, 11, 60> rgb <2, 1.3, 0.7> area_light 3*x, 3*y, 6, 6 circular orient jitter }
light_source { <-20, 30, -30> rgb <0.12, 0.15, 0.22> shadowless }
camera { location <-0.6, 1.5, -11> look_at <-0.1, 1.55, 0> angle 38 }
