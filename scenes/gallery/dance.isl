// Dance, after Matisse: five on a hill, hand in hand. In the painting two hands just fail to meet; here their fields do,
// and the ring is closed. Every figure is eleven joints drawn on the canvas, with a depth.
//   isl render scenes/gallery/dance.isl
#include "skins.isl"
#include "curves.isl"
#macro Limb(A, RA, B, RB, C, RC) convolution on Curve_limb(array[3] { A + RA*t, B + RB*t, C + RC*t }, 14) convolution off #end
// Z is the depth of the hip; then head, chest, hip, knee and foot, knee and foot, elbow and hand, elbow and hand.
#macro Dancer(Z, H, C, P, K1, F1, K2, F2, E1, A1, E2, A2)
  #local H = <H.x, H.y, Z - 0.1>;  #local C = <C.x, C.y, Z>;  #local P = <P.x, P.y, Z>;
  #local K1 = <K1.x, K1.y, Z - 0.25>;  #local F1 = <F1.x, F1.y, Z + 0.05>;
  #local K2 = <K2.x, K2.y, Z - 0.05>;  #local F2 = <F2.x, F2.y, Z + 0.3>;
  #local U = 0.8*vnormalize(vcross(C - P, z));                       // across the body
  #local Waist = 0.5*(C + P) + 0.06*z;
  blob { kernel "gaussian" hardness 8
    sphere { 0, 0.23 scale <0.85, 1.15, 0.95> translate H }
    sphere { 0, 0.235 strength 2 scale <1, 0.95, 1> translate H + <0, 0.13, 0.06> pigment { rgb <0.03, 0.008, 0.005> } } }
  cone { H - 0.1*y, 0.13, C, 0.17 }
  cone { C - 0.23*U, 0.2, C + 0.23*U, 0.2 }  Limb(C, 0.3, Waist, 0.22, P, 0.3)
  sphere { P - 0.17*U, 0.3 }  sphere { P + 0.17*U, 0.3 }
  Limb(P + 0.17*U, 0.27, K1, 0.18, F1, 0.09)
  Limb(P - 0.17*U, 0.27, K2, 0.18, F2, 0.09)
  #local D = 0.28*(F1.x > K1.x ? 1 : -1)*x;  cone { F1, 0.09, F1 + D - 0.06*y - 0.05*z, 0.06 }
  #local D = 0.28*(F2.x > K2.x ? 1 : -1)*x;  cone { F2, 0.09, F2 + D - 0.06*y - 0.05*z, 0.06 }
  Limb(C + 0.27*U, 0.16, E1, 0.115, A1, 0.08)
  Limb(C - 0.27*U, 0.16, E2, 0.115, A2, 0.08)
#end
#declare H12 = <-1.25, 4.35, 0.9>;  #declare H23 = <1.15, 4.35, 1.5>;  #declare H34 = <3.05, 3.45, 0.8>;
#declare H45 = <1.85, 1.95, -0.4>;  #declare H51 = <-1.45, 2.2, -0.4>;
blob {
  kernel "quartic" hardness 3
  Dancer(0, <-2.35, 4.75>, <-2.75, 3.95>, <-2.8, 2.6>, <-2.15, 1.6>, <-2.5, 0.38>, <-3.45, 1.6>, <-4.25, 0.5>,
    <-2.1, 3.0, -0.2>, H51, <-2.0, 4.15, 0.4>, H12)
  Dancer(1.6, <-0.4, 4.85>, <0, 4.25>, <0.2, 3.05>, <0.85, 2.5>, <0.35, 1.55>, <-0.55, 2.55>, <-0.5, 1.35>,
    <0.6, 4.35, 1.4>, H23, <-0.65, 4.05, 1.2>, H12)
  Dancer(1.5, <2.4, 4.85>, <2.05, 4.15>, <1.75, 3.0>, <2.45, 2.45>, <2.85, 1.45>, <1.25, 2.15>, <1.6, 1.2>,
    <2.7, 3.75, 1.2>, H34, <1.55, 4.0, 1.5>, H23)
  Dancer(0.2, <4.25, 3.95>, <3.75, 3.25>, <3.15, 2.2>, <3.8, 1.4>, <4.4, 0.5>, <2.5, 1.4>, <2.9, 0.52>,
    <2.75, 2.55, -0.1>, H45, <3.4, 3.6, 0.5>, H34)
  Dancer(-0.9, <-0.35, 2.4>, <0.2, 1.8>, <1.15, 1.0>, <0.25, 0.55>, <-0.45, -0.08>, <2.05, 0.65>, <3.0, 0.18>,
    <1.05, 1.95, -0.7>, H45, <-0.6, 1.9, -0.7>, H51)
  pigment { RimPigment(rgb <0.78, 0.12, 0.025>, rgb <0.1, 0.01, 0.005>) }
  finish { diffuse 0.9 }
}
blob { kernel "gaussian" hardness 2
  sphere { 0, 1 scale <7, 2, 6> translate <-4.5, -1.7, 1.5> } sphere { 0, 1 scale <6, 3, 5> translate <2.2, -1.8, 3> }
  pigment { rgb <0.02, 0.22, 0.06> } }
background { rgb <0.01, 0.035, 0.31> }
global_settings { sky_light { distance 3 } }
light_source { <-7, 12, -12> rgb <1, 0.97, 0.9> area_light 4*x, 4*z, 6, 6 circular orient jitter }
light_source { <8, 4, -12> rgb 0.2 shadowless }
camera { location <0.1, 3, -24> look_at <0.1, 2.35, 0> angle 22 }
