// A crab after the paper's Hermite crab (Sherstyuk 1999, Figure 7): 641 elements of five kinds of field in one blob, the largest a
// hundred times the smallest. Legs, claws and eyes are branches of one union: they grow out of the body, and where they cross
// they do not melt into one another.
//   isl render scenes/paper/hermite_crab.isl -s 960x640
//   isl render scenes/paper/hermite_crab.isl -s 960x640 --skeleton
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Ground) #declare Ground = 1; #end

camera { location <1.2, 3.4, -7.6> look_at <0, -0.15, -0.35> angle 44 right 1.5*x up y }
#ifdef (Soft)
  #include "../soft_studio.isl"
  Soft_studio(<6, 10, -7>, 4, y, 8)
#else
  light_source { <6, 10, -7> rgb 0.95 }
  light_source { <-8, 4, -5> rgb <0.26, 0.28, 0.34> shadowless }
  background { rgb <0.83, 0.88, 0.92> }
#end

#declare Shell = <0.78, 0.26, 0.16>;
#declare Pale = <0.93, 0.72, 0.52>;
#declare Dark = <0.22, 0.12, 0.12>;
#declare Chance = seed(641);
#macro Between(A, B) (A + (B - A) * rand(Chance)) #end
#declare Elements = 0;
#macro Count(N) #declare Elements = Elements + N; #end

// A limb from A to B with its joint at B, and N spines of thickness R along it.
#macro Limb(A, Ra, B, Rb, N, R)
  kernel "quartic" hardness 5
  cone { A, Ra, B, Rb }
  kernel "soft" hardness 5
  sphere { B, Rb * 1.08 }
  kernel "cauchy" hardness 6
  #local Along = vnormalize(B - A);
  #local Side = vnormalize(vcross(Along, <0.31, 0.93, 0.17>));
  #for (K, 0, N - 1)
    #local T = (K + 0.5) / N;
    #local Out = vaxis_rotate(Side, Along, 137.5 * K);
    #local Foot = A + T * (B - A) + 0.8 * (Ra + T * (Rb - Ra)) * Out;
    cone { Foot, R * 1.6, Foot + (Ra * 0.55 + R * 2) * Out + 0.03 * Along, R pigment { rgb Pale } }
  #end
  Count(2 + N)
#end

#macro Leg(Turn, Lift)
  blob {
    Limb(<0.55, 0, 0>, 0.17, <1.35, 0.62 + Lift, 0>, 0.13, 11, 0.012)
    Limb(<1.35, 0.62 + Lift, 0>, 0.12, <2.15, 0.05, 0>, 0.085, 11, 0.011)
    Limb(<2.15, 0.05, 0>, 0.08, <2.62, -0.92, 0>, 0.03, 10, 0.01)
    rotate Turn * y
    pigment { rgb Shell }
  }
#end

// A finger: five cones from Base that turn by Bend degrees each, with teeth on the inside.
#macro Finger(Base, Bend, Teeth)
  #local P = Base;
  #for (K, 0, 4)
    #local Q = P + vrotate(<0.17 - 0.012 * K, 0, 0>, (40 * (Bend > 0 ? -1 : 1) + Bend * K) * y);
    kernel "quartic" hardness 6
    cone { P, 0.105 - 0.018 * K, Q, 0.087 - 0.018 * K }
    kernel "metaball" hardness 4
    #for (J, 0, Teeth - 1)
      #local Inwards = vnormalize(vcross(Q - P, (Bend > 0 ? -y : y)));
      sphere { P + (J + 0.5) / Teeth * (Q - P) + (0.09 - 0.016 * K) * Inwards, 0.024 pigment { rgb Pale } }
    #end
    Count(1 + Teeth)
    #local P = Q;
  #end
#end

#macro Claw(Mirror)
  blob {
    Limb(<0.55, 0.1, -0.45>, 0.19, <1.15, 0.45, -1.05>, 0.17, 9, 0.013)
    Limb(<1.15, 0.45, -1.05>, 0.16, <0.95, 0.12, -1.75>, 0.13, 8, 0.012)
    kernel "gaussian" hardness 4
    sphere { 0, 0.30 scale <1, 0.75, 1.35> rotate 14 * y translate <0.80, 0.12, -2.05> }
    Count(1)
    blob { Finger(0, 22, 3) rotate 84 * y translate <0.87, 0.12, -2.28> }
    blob { Finger(0, -22, 3) rotate 108 * y translate <0.66, 0.12, -2.26> }
    scale <Mirror, 1, 1>
    pigment { rgb Shell * 1.1 }
  }
#end

#macro Eye(Mirror)
  blob {
    kernel "quartic" hardness 6
    cone { <0.22, 0.2, -0.72>, 0.06, <0.30, 0.62, -0.92>, 0.045 pigment { rgb Shell } }
    kernel "gaussian" hardness 8
    sphere { <0.31, 0.70, -0.94>, 0.095 pigment { rgb Dark } }
    scale <Mirror, 1, 1>
    Count(2)
  }
#end

blob {
  // The carapace: one broad ellipsoid, its rim, and bumps all over it.
  kernel "gaussian" hardness 5
  sphere { 0, 1 scale <1.12, 0.52, 0.86> }
  sphere { <0, -0.2, 0.1>, 0.6 scale <1.2, 0.6, 1> pigment { rgb Pale } }
  Count(2)
  kernel "metaball" hardness 4
  #for (I, 0, 35)
    #local A = radians(10 * I);
    sphere { <1.1 * cos(A), 0.02, 0.85 * sin(A)>, 0.075 pigment { rgb Pale } }
  #end
  Count(36)
  union {
    #for (I, 0, 3)
      Leg(-28 + 24 * I, 0.04 * I)
      Leg(208 - 24 * I, 0.04 * I)
    #end
    Claw(1) Claw(-1)
    Eye(1) Eye(-1)
  }
  kernel "soft" hardness 5
  #declare Bumps = 641 - Elements;
  #for (I, 0, Bumps - 1)
    #local Height = 1 - 0.85 * (I + 0.5) / Bumps;
    #local Out = vrotate(<sqrt(1 - Height * Height), Height, 0>, 137.508 * I * y);
    sphere { Out * <1.12, 0.52, 0.86>, Between(0.02, 0.05) }
  #end
  Count(Bumps)
  pigment { rgb Shell }
  finish { ambient 0.14 diffuse 0.72 phong 0.45 phong_size 50 }
}
#if (Ground) plane { y, -0.95 pigment { rgb <0.80, 0.74, 0.62> } finish { ambient 0.15 diffuse 0.75 } } #end
#debug concat(str(Elements, 0, 0), " elements, ", str(Bumps, 0, 0), " of them bumps\n")
