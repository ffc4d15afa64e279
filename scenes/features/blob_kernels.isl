// Every kernel, from soft to hard: two balls that melt into one another, the same radii in each row and column. Soft kernels
// reach far and swell where they meet; hard ones keep the balls apart.
//   isl render scenes/features/blob_kernels.isl -s 1200x640
#version 3.7;
global_settings { assumed_gamma 1 }

#declare Kernels = array[6] { "quartic", "cubic", "gaussian", "soft", "metaball", "cauchy" }
#declare Hardness = array[3] { 1, 3, 12 }
#declare Colours = array[6] {
  <0.78, 0.36, 0.30>, <0.86, 0.58, 0.28>, <0.83, 0.76, 0.38>, <0.40, 0.63, 0.45>, <0.30, 0.53, 0.70>, <0.52, 0.42, 0.66>
}

#for (Column, 0, 5)
  #for (Row, 0, 2)
    blob {
      kernel Kernels[Column] hardness Hardness[Row]
      sphere { <-0.45, -0.1, 0>, 0.5 }
      sphere { <0.36, 0.16, 0>, 0.36 }
      pigment { rgb Colours[Column] }
      finish { ambient 0.12 diffuse 0.75 phong 0.5 phong_size 60 }
      translate <1.95 * (Column - 2.5), 1.75 * (1 - Row), 0>
    }
  #end
#end

background { rgb <0.93, 0.92, 0.89> }
light_source { <-8, 12, -14> rgb 0.95 }
light_source { <9, 2, -10> rgb 0.25 shadowless }
camera { location <0, 0, -22> look_at 0 angle 31 right 1.875*x up y }
