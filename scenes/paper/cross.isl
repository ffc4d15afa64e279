// The cross (Sherstyuk 1999, section 3): two crossed segments, the paper's test of how well few interpolants follow a field.
// From the front the published solver looks right, from the side it does not:
//   isl render scenes/paper/cross.isl -s 400x400 --solver paper
//   isl render scenes/paper/cross.isl -s 400x400 --solver paper -D Side=1
//   isl render scenes/paper/cross.isl -s 400x400 -D Side=1
// With Convolve=1 the kernel is integrated along the segments, as it is in the paper; Kernel and Hardness choose it. With Balls=9 an
// arm is a row of nine balls, whose fields are smooth along every ray.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Side) #declare Side = 0; #end
#ifndef (Kernel) #declare Kernel = "gaussian"; #end
#ifndef (Hardness) #declare Hardness = 4; #end
#ifndef (Convolve) #declare Convolve = 0; #end
#ifndef (Balls) #declare Balls = 0; #end

camera { location (Side ? <-7, 0.6, 0.35> : <0, 0, -7>) look_at 0 angle 32 right x up y }
light_source { <-6, 8, -9> rgb 0.95 }
light_source { <-8, -3, 6> rgb 0.25 shadowless }
background { rgb <0.92, 0.92, 0.90> }

blob {
  kernel Kernel hardness Hardness
  #if (Convolve) convolution on #end
  #if (Balls)
    #for (I, 0, Balls - 1)
      #local Along = 2.4 * I / (Balls - 1) - 1.2;
      sphere { <Along, Along, 0>, 0.3 }
      sphere { <-Along, Along, 0>, 0.3 }
    #end
  #else
    cylinder { <-1.2, -1.2, 0>, <1.2, 1.2, 0>, 0.3 }
    cylinder { <-1.2, 1.2, 0>, <1.2, -1.2, 0>, 0.3 }
  #end
  pigment { rgb <0.85, 0.52, 0.26> }
  finish { ambient 0.12 diffuse 0.75 phong 0.5 phong_size 60 }
}
