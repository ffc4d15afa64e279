// Slot: the water that is gone. The blob is the room that a flood has left, taken out of banded rock and seen from
// within. A row of lamps without shadows stands for the light that its walls throw at each other.
//   isl render scenes/gallery/canyon.isl
#include "skies.isl"
#default { finish { ambient rgb <0.07, 0.035, 0.07> diffuse 0.8 } }
#declare Chance = seed(5);
#macro Between(A, B) (A + (B - A) * rand(Chance)) #end
#declare Mid = function (y, z) { 0.7*sin(0.55*z) + 0.5*sin(0.8*y + 0.35*z) + 0.25*sin(1.7*y - 0.6*z) }
#declare Rock = texture {
  pigment {
    gradient y turbulence 0.06 octaves 3
    color_map { [0 rgb <0.62, 0.24, 0.1>] [0.25 rgb <0.75, 0.33, 0.14>] [0.4 rgb <0.5, 0.17, 0.09>] [0.55 rgb <0.8, 0.4, 0.19>]
                [0.8 rgb <0.68, 0.27, 0.12>] [1 rgb <0.62, 0.24, 0.1>] }
    rotate 12*z rotate 10*x scale 0.4
  }
  normal { average normal_map { [1 gradient y 0.3 sine_wave turbulence 0.06 octaves 3 rotate 12*z rotate 10*x scale 0.1]
                                [1 granite 0.2 scale 0.25] } }
}
#declare Water = blob {
  kernel "quartic" hardness 4
  #for (I, 0, 22)
    #for (J, 0, 9)
      #local Z = 0.8*I - 2;  #local Y = 0.9*J - 0.3;
      sphere { 0, 1 scale <Between(0.55, 0.95)*(1.25 - 0.08*J), Between(0.5, 0.9), Between(0.7, 1.2)>
        rotate <Between(-30, 30), Between(-25, 25), Between(-25, 25)> translate <Mid(Y, Z), Y, Z> }
    #end
  #end
  texture { Rock }
}
object { Water clipped_by { plane { y, 7.6 } } }
plane { y, -0.4 pigment { rgb <0.7, 0.4, 0.2> } }
background { rgb <0.8, 0.75, 0.8> }
light_source { <-10, -60, 10> rgb <0.35, 0.13, 0.12> shadowless }
light_source { <50, 5, -40> rgb <0.14, 0.07, 0.24> shadowless }
light_source { <6, 60, 12> rgb <1.9, 1.6, 1.1> }
#for (Z, 0, 12, 3) light_source { <Mid(6, Z), 6.5, Z> rgb <2.2, 1.35, 0.5> fade_distance 2 fade_power 2 shadowless } #end
#declare CZ = 1.5;  #declare LY = 2.7;
#declare Eye = <Mid(1.2, CZ), 1.2, CZ>;
#if (!inside(Water, Eye)) #error "the camera is in the rock" #end
camera { location Eye look_at <Mid(LY, CZ + 3), LY, CZ + 3> angle 75 }
