// A reef of ten thousand copies of one coral of 500 fields: five million fields in all, of which the program keeps 500 and
// where the copies stand.
//
//   isl render scenes/features/instances.isl
//   isl render scenes/features/instances.isl -D Copies=100000      ten times as many, five megabytes more for each ten thousand
#version 3.7;
global_settings { assumed_gamma 1 }

#ifndef (Copies) #declare Copies = 10000; #end

camera { location <0, 4.2, -13> look_at <0, 0.4, 4> angle 48 }
light_source { <-60, 90, -30> rgb <1.15, 1.1, 1.0> }
background { color srgb <0.10, 0.30, 0.42> }

// A fan of tapered twigs that lean out from a common foot, the longer the steeper.
#declare Chance = seed(7);
#declare Coral = blob {
  kernel "gaussian" hardness 5
  threshold 1
  #for (I, 1, 500)
    #local Height = sqrt(rand(Chance));
    #local Turn = 360 * rand(Chance);
    #local Foot = vrotate(<0.42 * Height * rand(Chance), Height * 0.8, 0>, Turn * y);
    #local Tip = Foot * <1.35, 1, 1.35> + 0.22 * y;
    cone { Foot, 0.045, Tip, 0.018 }
  #end
}

#declare Colours = array[5] { srgb <0.95, 0.45, 0.38>, srgb <0.98, 0.68, 0.42>, srgb <0.86, 0.36, 0.52>, srgb <0.55, 0.42, 0.70>,
                              srgb <0.97, 0.86, 0.62> }
#declare Textures = array[5]
#for (I, 0, 4)
  #declare Textures[I] = texture {
    pigment { color Colours[I] }
    finish { ambient 0.18 diffuse 0.7 specular 0.15 roughness 0.05 }
  }
#end

// Spread by chance, in drifts of one colour.
#declare Width = 44;
#declare Depth = 60;
#for (I, 0, Copies - 1)
  #local X = rand(Chance);
  #local Z = (I + 0.5) / Copies;
  #local Drift = sin(9 * X + 4 * Z) + sin(5 * Z - 7 * X + 1) + 0.7 * (rand(Chance) - 0.5);
  object {
    Coral
    texture { Textures[int(min(max(2.5 + 1.3 * Drift, 0), 4.999))] }
    rotate 360 * rand(Chance) * y
    scale 0.28 + 0.5 * rand(Chance) * rand(Chance)
    translate <(X - 0.5) * Width, 0.35 * sin(0.5 * X * Width) * cos(0.4 * Z * Depth), Z * Depth - 7>
  }
#end

plane {
  y, -0.3
  pigment { color srgb <0.62, 0.66, 0.58> }
  finish { ambient 0.15 diffuse 0.6 }
}
