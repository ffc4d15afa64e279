// Skeleton coordinates: with a kernel in force, uv_mapping in a blob means along each skeleton (u) and around it (v), so that a
// pattern follows a limb wherever it goes; where components melt into one another, so do their patterns.
//   isl render scenes/features/uv_blobs.isl -s 1200x560
#version 3.7;
global_settings { assumed_gamma 1 }

#ifndef (Kernel) #declare Kernel = "gaussian"; #end
#ifndef (Hardness) #declare Hardness = 5; #end

#macro Checks(Along, Around, C)
  texture {
    uv_mapping
    pigment { checker rgb C, rgb <0.95, 0.92, 0.85> scale <1/Along, 1/Around, 1> }
    finish { ambient 0.14 diffuse 0.75 phong 0.35 phong_size 60 }
  }
#end

// Above every skeleton alone, below with a ball whose pattern takes over where it is nearer; out of the box it is carved, and what
// carves colours the hollow.
#macro Skeleton(I, C)
  #switch (I)
    #case (0) sphere { 0, 0.75 Checks(16, 8, C) rotate <-20, 0, 25> } #break
    #case (1) cylinder { <-0.65, -0.3, 0>, <0.65, 0.3, 0>, 0.3 Checks(8, 8, C) } #break
    #case (2) cone { <-0.5, -0.4, 0>, 0.42, <0.7, 0.55, 0>, 0.12 Checks(8, 8, C) } #break
    #case (3) box { <-0.55, -0.35, -0.55>, <0.55, 0.35, 0.55>, 0.16 Checks(16, 12, C) rotate <15, 30, 0> } #break
    #case (4) torus { 0.72, 0.2 Checks(24, 8, C) rotate <-55, 0, 20> } #break
    #case (5) triangle { <-0.75, -0.55, 0.2>, <0.8, -0.4, -0.3>, <0, 0.8, 0>, 0.13 Checks(6, 6, C) } #break
  #end
#end

#declare Colours = array[6] {
  <0.72, 0.22, 0.20>, <0.80, 0.45, 0.14>, <0.62, 0.52, 0.10>, <0.20, 0.48, 0.26>, <0.14, 0.38, 0.60>, <0.40, 0.26, 0.56>
}
#declare Balls = array[6] {
  <0.6, -0.55, -0.3>, <0.3, -0.2, -0.3>, <0.35, -0.3, -0.2>, <-0.15, -0.1, -0.8>, <0.5, -0.45, -0.2>, <0.35, -0.45, -0.35>
}

#for (I, 0, 5)
  #for (Row, 0, 1)
    blob {
      kernel Kernel hardness Hardness
      Skeleton(I, Colours[I])
      #if (Row = 1) sphere { Balls[I], 0.36 strength (I = 3 ? -6 : 1) Checks(12, 6, <0.25, 0.25, 0.28>) } #end
      translate <2.5 * (I - 2.5), 1.3 - 2.7 * Row, 0>
    }
  #end
#end

camera { location <0, 0, -60> right x * image_width / image_height look_at 0 angle 14.6 }
light_source { <-8, 12, -14>, 1 }
light_source { <14, 2, -9>, 0.35 shadowless }
background { rgb <0.94, 0.93, 0.90> }
