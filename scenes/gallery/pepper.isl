// Pepper, after Edward Weston: four lobes that lean into one another like people. Nothing else; light from above.
//   isl render scenes/gallery/pepper.isl
#include "curves.isl"
#include "skies.isl"
#macro Lobe(A, Twist, Out, Low, High, R)
  Curve_limb(array[6] {
    vrotate(<0.3*Out, Low, 0>, A*y) + 0.6*R*t,
    vrotate(<0.85*Out, Low + 0.15*(High - Low), 0>, (A + 0.1*Twist)*y) + 0.85*R*t,
    vrotate(<1.05*Out, Low + 0.42*(High - Low), 0>, (A + 0.4*Twist)*y) + 0.95*R*t,
    vrotate(<1.2*Out, Low + 0.7*(High - Low), 0>, (A + 0.7*Twist)*y) + 1.05*R*t,
    vrotate(<1.0*Out, Low + 0.92*(High - Low), 0>, (A + 0.9*Twist)*y) + 0.85*R*t,
    vrotate(<0.35*Out, High - 0.1, 0>, (A + Twist)*y) + 0.5*R*t }, 20)
#end
#declare Pepper = blob {
  kernel "quartic" hardness 5 convolution on
  Lobe(250, 120, 0.47, 0.36, 2.3, 0.4)
  Lobe(330, 105, 0.5, 0.55, 2.0, 0.45)
  Lobe(60, 110, 0.45, 0.36, 2.1, 0.43)
  Lobe(150, 125, 0.47, 0.42, 2.32, 0.39)
  Lobe(200, 120, 0.3, 0.3, 1.6, 0.3)
  Curve_limb(array[2] { 0.5*y + 0.34*t, 1.9*y + 0.34*t }, 8)                  // the core
  kernel "quartic" hardness 5
  Curve_limb(array[4] { <0, 1.7, 0, 0.15>, <0.02, 2.3, 0, 0.11>, <0.1, 2.6, 0.03, 0.075>, <0.3, 2.85, -0.05, 0.1> }, 14)
  pigment { rgb 0.32 }
  normal { bumps 0.05 scale 0.25 }
  finish { ambient 0.015 diffuse 0.75 specular 0.2 roughness 0.03 reflection { 0.01, 0.3 falloff 4 } }
}
object { Pepper rotate 185*y rotate 10*z translate 0.1*x }
blob {                                                            // floor and wall melt, too
  kernel "gaussian" hardness 2 plane { -z, -3.2, 1 } plane { y, -1, 1 }
  pigment { rgb 0.02 } finish { ambient 0.02 diffuse 0.8 specular 0.03 roughness 0.1 }
}
sky_sphere { SkyGradient(rgb 0.01, rgb 0.03, rgb 0.05) SkyPanel(<0.5, 1, -0.3>, 50, 35, rgb 3) SkyPanel(<-1, 0.5, -0.5>, 14, 50, rgb 1) }
light_source { <2.5, 6, -2.5> rgb 2.9 area_light 4.5*x, 4.5*z, 8, 8 circular orient jitter }
light_source { <-6, 3, 1> rgb 0.12 shadowless }
light_source { <2, 5, -1> rgb 1.2 spotlight point_at <-0.7, 1.7, 3.2> radius 4 falloff 22 shadowless }
camera { location <0, 1.7, -7> look_at <0.05, 1.42, 0> angle 34 }
