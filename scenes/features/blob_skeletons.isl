// Every skeleton of a blob, alone above and melting into a ball below: point, segment, round cone, box, circle, triangle and
// disc.
//   isl render scenes/features/blob_skeletons.isl -s 1400x560
#version 3.7;
global_settings { assumed_gamma 1 }

#ifndef (Kernel) #declare Kernel = "gaussian"; #end
#ifndef (Hardness) #declare Hardness = 5; #end

#macro Skeleton(I)
  #switch (I)
    #case (0) sphere { 0, 0.75 } #break
    #case (1) cylinder { <-0.65, -0.3, 0>, <0.65, 0.3, 0>, 0.3 } #break
    #case (2) cone { <-0.5, -0.4, 0>, 0.42, <0.7, 0.55, 0>, 0.12 } #break
    #case (3) box { <-0.55, -0.35, -0.55>, <0.55, 0.35, 0.55>, 0.16 rotate <15, 30, 0> } #break
    #case (4) torus { 0.72, 0.2 rotate <-55, 0, 20> } #break
    #case (5) triangle { <-0.75, -0.55, 0.2>, <0.8, -0.4, -0.3>, <0, 0.8, 0>, 0.13 } #break
    #case (6) disc { 0, <0.25, 0.8, -0.55>, 0.7, 0.15 } #break
  #end
#end

#declare Colours = array[7] {
  <0.86, 0.37, 0.34>, <0.91, 0.61, 0.31>, <0.88, 0.80, 0.42>, <0.45, 0.70, 0.46>, <0.33, 0.57, 0.77>, <0.58, 0.45, 0.72>,
  <0.55, 0.50, 0.44>
}

#declare Balls = array[7] {
  <0.6, -0.55, -0.3>, <0.3, -0.2, -0.3>, <0.35, -0.3, -0.2>, <0.6, -0.5, -0.4>, <0.5, -0.45, -0.2>, <0.35, -0.45, -0.35>,
  <0.35, 0.1, -0.2>
}

#for (I, 0, 6)
  #for (Row, 0, 1)
    blob {
      kernel Kernel hardness Hardness
      Skeleton(I)
      #if (Row = 1) sphere { Balls[I], 0.36 } #end
      pigment { rgb Colours[I] }
      finish { ambient 0.12 diffuse 0.75 phong 0.45 phong_size 60 }
      translate <2.5 * (I - 3), 1.3 - 2.7 * Row, 0>
    }
  #end
#end

camera { location <0, 0, -60> right x * image_width / image_height look_at 0 angle 17 }
light_source { <-8, 12, -14>, 1 }
light_source { <14, 2, -9>, 0.35 shadowless }
background { rgb <0.94, 0.93, 0.90> }
