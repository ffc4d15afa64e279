// The second sea urchin (Sherstyuk 1999, Figure 5): the body and every spine have texture coordinates of their own, and what they
// look like cross-dissolves where their fields do. A spine is banded along its own length (u); the body has ten seams from pole to
// pole and rings between them (u round it, v up it); at the foot of a spine one pattern runs into the other.
//   isl render scenes/paper/sea_urchin_uv.isl -s 900x900
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Spines) #declare Spines = 210; #end

camera { location <0, 2.6, -8> look_at <0, 0.02, 0> angle 31 right x up y }
light_source { <5, 9, -7> rgb <1.00, 0.95, 0.86> * 1.15 }
light_source { <-9, 2, -5> rgb <0.22, 0.32, 0.46> shadowless }
light_source { <2, -6, -4> rgb <0.20, 0.10, 0.14> shadowless }

// The water behind it, lighter where the light comes from.
plane { z, 7
  pigment {
    spherical
    color_map { [0 srgb <0.02, 0.10, 0.20>] [0.5 srgb <0.05, 0.26, 0.38>] [1 srgb <0.34, 0.62, 0.66>] }
    scale 8 translate <2.4, 2.2, 7>
  }
  finish { ambient 1 diffuse 0 }
}

#declare Spine = texture {
  uv_mapping
  pigment {
    gradient x
    color_map {
      [0.00 srgb <0.30, 0.04, 0.22>] [0.14 srgb <0.38, 0.05, 0.26>] [0.30 srgb <0.78, 0.10, 0.30>]
      [0.30 srgb <0.99, 0.80, 0.52>] [0.35 srgb <0.99, 0.80, 0.52>] [0.35 srgb <0.74, 0.09, 0.28>] [0.50 srgb <0.92, 0.27, 0.22>]
      [0.50 srgb <1.00, 0.86, 0.58>] [0.55 srgb <1.00, 0.86, 0.58>] [0.55 srgb <0.90, 0.28, 0.22>] [0.70 srgb <0.97, 0.50, 0.22>]
      [0.70 srgb <1.00, 0.92, 0.66>] [0.75 srgb <1.00, 0.92, 0.66>] [0.75 srgb <0.97, 0.54, 0.25>] [1.00 srgb <1.00, 0.88, 0.52>]
    }
  }
  finish { ambient 0.07 diffuse 0.85 phong 0.45 phong_size 70 }
}

#declare Rings = color_map {
  [0 srgb <0.98, 0.80, 0.36>] [0.10 srgb <0.98, 0.80, 0.36>] [0.18 srgb <0.05, 0.48, 0.52>] [1 srgb <0.03, 0.25, 0.38>]
}
#declare Body = texture {
  uv_mapping
  pigment {
    gradient x
    pigment_map {
      [0.10 srgb <0.98, 0.82, 0.40>]
      [0.17 gradient y color_map { Rings } triangle_wave scale 10/14]
    }
    triangle_wave
    scale 1/10
  }
  finish { ambient 0.07 diffuse 0.85 phong 0.6 phong_size 60 }
}

// Directions spread evenly: equal steps of height, and the golden angle from one to the next.
#declare GoldenAngle = 180 * (3 - sqrt(5));
#macro Direction(I)
  #local Height = 1 - (2 * I + 1) / Spines;
  vrotate(<sqrt(1 - Height * Height), Height, 0>, GoldenAngle * I * y)
#end

#declare Lengths = seed(11);
blob {
  kernel "gaussian" hardness 5
  sphere { 0, 0.95 texture { Body } rotate <-24, 0, 14> }
  kernel "quartic" hardness 5
  #for (I, 0, Spines - 1)
    #local Spread = Direction(I);
    cone { 0.85 * Spread, 0.085, (1.7 + 0.5 * rand(Lengths)) * Spread, 0.012 texture { Spine } }
  #end
}
