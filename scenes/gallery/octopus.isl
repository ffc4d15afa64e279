// An octopus at rest on the sea floor: eight arms that sink, turn about themselves and curl in by one rule, from the
// web between them to the last sucker one blob.
//   isl render scenes/gallery/octopus.isl
#version 3.7;
#include "skins.isl"
global_settings { assumed_gamma 1 ambient_light rgb <0.8, 2.8, 3.4> }

camera { location <0.3, 2.1, -9> look_at <0.03, 1.2, 0> angle 38.5 }
// The water is dark ahead and has shafts of light above; what is far takes its colour.
sky_sphere {
  pigment { bozo scale <0.05, 1.5, 0.05> rotate -24*z color_map { [0.4 rgb <0, 0.5, 0.75>] [0.9 rgb <0.2, 1.9, 2.2>] } }
  pigment { gradient y
    color_map { [0 rgb <0.01, 0.06, 0.07>] [0.04 rgb <0.01, 0.07, 0.09>] [0.4 rgbt <0.01, 0.1, 0.14, 1>] } } }
fog { distance 10 rgbt <0.004, 0.04, 0.065, 0.2> }
light_source { <-5, 14, -5> rgb <6.4, 5.6, 4.4> spotlight point_at <0, 0.5, 0> radius 8 falloff 24
  area_light 0.3*x, 0.3*z, 3, 3 circular orient jitter }
light_source { <6, 5, 6> rgb <0.3, 0.85, 1.05> shadowless }
light_source { <-2, 9, -9> rgb <0.1, 0.2, 0.24> shadowless }
// Waves gather the light into a net. The camera does not see them, because they hang lower than they should.
plane { y, 5 hollow no_image no_reflection pigment { crackle turbulence 0.3 scale 0.9
  color_map { [0 rgbt 1] [0.05 rgbt <1, 1, 1, 0.8>] [0.2 rgbt <1, 1, 1, 0.3>] } } }

#declare Skin = texture {
  pigment { bozo turbulence 0.6 octaves 4 scale 0.3
    color_map { [0.25 rgb <0.9, 0.36, 0.14>] [0.5 rgb <0.6, 0.11, 0.04>] [0.75 rgb <0.22, 0.022, 0.025>] } }
  normal { average normal_map { [1 bumps 0.6 scale 0.035] [1 wrinkles 0.6 scale 0.2] } }
  finish { GlossyFinish(0.55) }
}
#declare Pale = texture { pigment { rgb <0.95, 0.68, 0.52> } finish { GlossyFinish(0.4) } }

// An arm that leaves the body at the angle Way and climbs by Rise. It turns about itself by Twist degrees, and from the
// share Free of its length on it bends towards its suckers, by Coil over its radius, which makes a spiral of it.
#macro Arm(Way, Rise, Length, Free, Twist, Coil)
  #local P = vrotate(<0.4, 0.55, 0>, Way*y);
  #local T = vrotate(vnormalize(<1, Rise, 0>), Way*y);
  #local N = -y;  #local S = 0;
  #while (S < 1)
    #local R = 0.29*pow(1 - S, 0.9) + 0.018;
    #local Step = 0.72*R;
    #local N = vaxis_rotate(vnormalize(N - vdot(N, T)*T), T, Twist*Step/Length);
    sphere { P, R strength 0.88 texture { Skin } }
    sphere { P + 0.6*R*N, 0.55*R strength 0.6 texture { Pale } }
    #for (Side, -30, 30, 60)      // two suckers, rings that face away from the arm
      #local D = vaxis_rotate(N, T, Side);
      #local E = vcross(T, D);
      #local Q = P + 1.02*R*D;
      torus { 0.25*R, 0.11*R texture { Pale } matrix <T.x, T.y, T.z, D.x, D.y, D.z, E.x, E.y, E.z, Q.x, Q.y, Q.z> }
    #end
    #local T = vaxis_rotate(T, vcross(T, N), Coil*max(0, min(1, 4*(S - Free)))*degrees(Step/R));
    // Its weight draws it down, and the floor holds it.
    #local T = vnormalize(T + (P.y < 0.8*R ? 1.5*(0.8*R - P.y) - min(0, T.y) : (S < Free ? -0.9*Step : 0))*y);
    #local P = P + Step*T;
    #local S = S + Step/Length;
  #end
#end

blob {
  kernel "gaussian" hardness 5
  Arm(-104, 0, 4.6, 0.42, 150, 0.36)  Arm(-150, 0.2, 5.0, 0.35, 120, 0.34)
  Arm(-60, 0, 4.4, 0.35, -120, 0.36)  Arm(-14, 1.3, 4.6, 0.3, -190, 0.25)
  Arm(25, 0, 4.6, 0.35, 150, 0.36)    Arm(70, 0.6, 4.4, 0.4, -120, 0.36)
  Arm(125, 0.5, 4.4, 0.4, -150, 0.36) Arm(172, 1.0, 4.8, 0.35, 170, 0.25)
  cone { <0, 0.6, 0>, 0.5, <-0.05, 1.25, 0.05>, 0.44 }
  sphere { 0, 0.9 scale <0.86, 1.2, 0.86> rotate <22, 0, 32> translate <-0.72, 2.05, 0.5> }
  #for (Way, -35, 88, 123)      // a mound and a lid for each eye
    sphere { <0, 1.34, -0.32>, 0.27 rotate -Way*y }
    torus { 0.17, 0.05 rotate 90*x translate <0, 1.41, -0.47> rotate -Way*y }
  #end
  texture { Skin }
}
#for (Way, -35, 88, 123)
  union {
    sphere { 0, 0.17 pigment { RimPigment(rgb <0.85, 0.33, 0.05>, rgb <0.25, 0.05, 0.01>) } }
    intersection { sphere { 0, 0.172 } sphere { -0.7*z, 0.6 scale <0.45, 0.19, 1> } pigment { rgb 0.01 } }
    finish { WetFinish } translate <0, 1.4, -0.52> rotate -Way*y
  }
#end
plane { y, 0 pigment { granite scale 2 color_map { [0.2 rgb <0.15, 0.13, 0.1>] [0.8 rgb <0.3, 0.26, 0.2>] } }
  normal { average normal_map { [1 ripples 0.4 turbulence 0.5 scale 0.7 translate <7, 0, 4>] [1 granite 0.2] } } }
