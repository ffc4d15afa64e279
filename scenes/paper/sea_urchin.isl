// The sea urchin (Sherstyuk 1999, Figure 5): a Gaussian core and radial spikes, many of them thinner than a pixel. None of them may
// be missed, however thin: where a pixel's samples meet one is for its coverage to say, not for a step length.
//   isl render scenes/paper/sea_urchin.isl -s 640x640
//   isl render scenes/paper/sea_urchin.isl -s 640x640 -D Thickness=0.1
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Thickness) #declare Thickness = 1; #end
#ifndef (Spikes) #declare Spikes = 420; #end

camera { location <0, 1.6, -7.5> look_at 0 angle 38 right x up y }
#ifdef (Soft)
  #include "../soft_studio.isl"
  Soft_studio(<6, 9, -7>, 4, y, 8)
#else
  light_source { <6, 9, -7> rgb 0.95 }
  light_source { <-7, 1, -4> rgb <0.30, 0.30, 0.42> shadowless }
  background { rgb <0.86, 0.90, 0.93> }
#end

// Directions spread evenly: equal steps of height, and the golden angle from one to the next.
#declare GoldenAngle = 180 * (3 - sqrt(5));
#macro Direction(I)
  #local Height = 1 - (2 * I + 1) / Spikes;
  vrotate(<sqrt(1 - Height * Height), Height, 0>, GoldenAngle * I * y)
#end

#declare Lengths = seed(31);
blob {
  kernel "gaussian" hardness 6
  sphere { 0, 0.8 pigment { rgb <0.24, 0.10, 0.20> } }
  kernel "quartic" hardness 6
  #for (I, 0, Spikes - 1)
    cone {
      0.72 * Direction(I), 0.05 * Thickness, (1.5 + 0.5 * rand(Lengths)) * Direction(I), 0.008 * Thickness
      pigment { rgb <0.55, 0.22, 0.42> }
    }
  #end
  finish { ambient 0.14 diffuse 0.72 phong 0.4 phong_size 40 }
}
