// Twenty blobs that POV-Ray and isl describe alike: -D Case=1 … 20, or POV-Ray's Declare=Case=1.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Case) #declare Case = 1; #end

camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <6, 8, -6> rgb 0.8 }
light_source { <-8, 3, -4> rgb <0.2, 0.25, 0.35> }
background { rgb <0.3, 0.35, 0.4> }

#declare Plain = texture { pigment { rgb <0.8, 0.5, 0.3> } finish { ambient 0.1 diffuse 0.8 } };
#declare Shiny = texture { pigment { rgb <0.3, 0.5, 0.8> } finish { ambient 0.15 diffuse 0.6 phong 0.8 phong_size 60 } };
#declare Glossy = texture { pigment { rgb <0.4, 0.7, 0.4> } finish { ambient 0.1 diffuse 0.7 specular 0.6 roughness 0.03 } };
#declare Numbers = seed(Case);
#macro Between(A, B) (A + (B - A) * rand(Numbers)) #end
#macro Somewhere(R) <Between(-R, R), Between(-R, R), Between(-R, R)> #end

#switch (Case)
  #case (1) blob { threshold 0.5 sphere { 0, 2, 1 } texture { Plain } } #break
  #case (2) blob { threshold 0.4 sphere { -0.7*x, 1.4, 1 } sphere { 0.7*x, 1.4, 1 } texture { Shiny } } #break
  #case (3) blob { threshold 0.3 sphere { -0.8*x, 1.4, 1 } sphere { 0.8*x, 1.4, 1 } sphere { 0.9*y, 1.2, 1 } texture { Glossy } } #break
  #case (4) blob { threshold 0.5 cylinder { -1.2*x, 1.2*x, 0.9, 1 } texture { Plain } } #break
  #case (5) blob { threshold 0.3 cylinder { -1.2*x, 1.2*x, 0.7, 1 } cylinder { -1.2*y, 1.2*y, 0.7, 1 } texture { Shiny } } #break
  #case (6) blob { threshold 0.4 sphere { 0, 2, 1 } sphere { <0.6, 0.6, -0.7>, 0.9, -1 } texture { Glossy } } #break
  #case (7) blob { threshold 0.4 sphere { 0, 2, 1.2 } cylinder { -2*z, 2*z, 0.7, -1 } texture { Plain } } #break
  #case (8)
    blob {
      threshold 0.5
      sphere { -0.7*x, 1.5, 1 texture { Plain } }
      sphere { 0.7*x, 1.5, 1 texture { Shiny } }
    }
  #break
  #case (9) blob { threshold 0.5 sphere { 0, 1, 1.5 scale <1.8, 0.9, 1> rotate 30*z } sphere { 0.6*y, 1, 1 } texture { Glossy } } #break
  #case (10)
    blob { threshold 0.3 #for (I, 0, 11) sphere { vrotate(1.2*x, 30*I*y) + 0.2*sin(I)*y, 0.7, 1 } #end texture { Shiny } }
  #break
  #case (11)
    blob { threshold 0.6 #for (I, 0, 39) sphere { Somewhere(1), 0.6, 1 } #end texture { Plain } }
  #break
  #case (12)
    blob { threshold 0.5 #for (I, 0, 39) sphere { Somewhere(1), 0.7, Between(-0.6, 1.4) } #end texture { Glossy } }
  #break
  #case (13)
    blob { threshold 0.4 #for (I, 0, 24) cylinder { Somewhere(0.9), Somewhere(0.9), 0.4, 1 } #end texture { Shiny } }
  #break
  #case (14)
    blob {
      threshold 0.5
      #for (I, 0, 24) sphere { Somewhere(1), 0.8, 1 pigment { rgb <Between(0, 1), Between(0, 1), Between(0, 1)> } } #end
      finish { ambient 0.1 diffuse 0.8 }
    }
  #break
  #case (15) blob { threshold 0.05 sphere { 0, 1.3, 1 } sphere { <1, 0.5, 0>, 0.9, 1 } texture { Plain } } #break
  #case (16) blob { threshold 0.95 sphere { 0, 3, 1 } sphere { <1, 0.5, 0>, 2, 1 } texture { Shiny } } #break
  #case (17)
    union {
      blob { threshold 0.5 sphere { 0, 1, 1 } sphere { 0.7*x, 1, 1 } texture { Plain } translate <-1, 0.6, 0> }
      blob { threshold 0.5 sphere { 0, 1, 1 } sphere { 0.7*y, 1, 1 } texture { Shiny } scale <1, 0.7, 1.3> rotate 40 translate <0.9, -0.3, 0> }
    }
  #break
  #case (18)
    blob { threshold 0.5 sphere { 0, 1.6, 1 } cylinder { 0, 1.4*y, 0.6, 1 } texture { Glossy } }
    plane { y, -1 texture { Plain } }
  #break
  #case (19)
    blob { threshold 0.3 #for (I, 0, 59) sphere { vrotate((0.4 + 0.015*I)*x, <0, 40*I, 0>) + (I/40 - 0.75)*y, 0.35, 1 } #end texture { Plain } }
  #break
  #case (20)
    blob {
      threshold 0.4
      sphere { 0, 1.8, 1 }
      #for (I, 0, 30) sphere { vrotate(vrotate(0.85*x, Between(-80, 80)*z), Between(0, 360)*y), 0.35, Between(-1, 1) } #end
      texture { Glossy }
    }
  #break
#end
