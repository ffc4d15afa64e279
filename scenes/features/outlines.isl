// Outlines with depth: letters cut into stone, letters of brass, a gear, a star that runs to a point, a cookie of curves.
//   isl render scenes/features/outlines.isl -s 1000x500
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }

camera { location <0, 5.2, -10> look_at <0, 0.75, 0> angle 56 right 2*x up y }
light_source { <-7, 9, -6> rgb 1.1 }
light_source { <8, 4, -7> rgb <0.22, 0.24, 0.3> shadowless }
background { rgb <0.2, 0.24, 0.32> }

plane { y, 0 pigment { rgb <0.34, 0.33, 0.32> } finish { ambient 0.05 diffuse 0.6 reflection { 0.02, 0.25 falloff 4 } } }

#declare Brass = texture {
  pigment { rgb <0.86, 0.62, 0.28> }
  finish { ambient 0.05 diffuse 0.35 specular 0.7 roughness 0.02 metallic reflection { 0.35 metallic } }
}

// A word cut a fifth deep into a slab.
difference {
  box { <-3.4, 0, 0>, <3.4, 2.3, 0.9> }
  text { ttf "timrom.ttf" "outline" 0.4, 0 scale <2.05, 2.05, 1> translate <-2.95, 0.72, -0.2> }
  pigment { granite color_map { [0 rgb 0.92] [0.45 rgb 0.8] [0.6 rgb <0.66, 0.62, 0.6>] [1 rgb 0.5] } scale 1.6 }
  finish { ambient 0.05 diffuse 0.75 }
  translate 1.2*z
}

text { ttf "timrom.ttf" "&" 0.35, 0 scale 2.1 rotate 28*y translate <3.1, 0.02, -1.7> texture { Brass } }

#declare Teeth = 14;
#declare Gear = prism {
  linear_spline 0, 0.45, 4*Teeth + 1
  #for (I, 0, 4*Teeth)
    #local A = 2*pi*(I + 0.3*mod(I, 2))/(4*Teeth);
    #local R = (mod(I, 4) < 2 ? 1 : 0.78);
    <R*cos(A), R*sin(A)>
  #end
}
difference {
  object { Gear }
  cylinder { -y, y, 0.25 }
  texture { Brass }
  rotate <-70, 25, 0>
  translate <-3.2, 1, -1.2>
}

// The points of a conic sweep are those at the height 1; the sides meet at the origin.
prism {
  conic_sweep linear_spline 0, 1, 11
  #for (I, 0, 10)
    #local R = (mod(I, 2) ? 0.42 : 1);
    <R*sin(pi*I/5), R*cos(pi*I/5)>
  #end
  rotate 180*x
  translate y
  scale <0.95, 1.15, 0.95>
  translate <0.9, 0, -1.9>
  pigment { rgb <0.75, 0.16, 0.14> }
  finish { ambient 0.05 diffuse 0.65 specular 0.4 roughness 0.03 }
}

prism {
  bezier_spline 0, 0.3, 16
  <0, -1>, <0.55, -1>, <0.2, -0.2>, <1, -0.2>, <1, -0.2>, <1.3, 0.5>, <0.5, 0.5>, <0, 1>,
  <0, 1>, <-0.5, 0.5>, <-1.3, 0.5>, <-1, -0.2>, <-1, -0.2>, <-0.2, -0.2>, <-0.55, -1>, <0, -1>
  rotate -20*y
  scale 0.85
  translate <-1.1, 0, -2.2>
  pigment { rgb <0.35, 0.5, 0.6> }
  finish { ambient 0.05 diffuse 0.65 specular 0.3 roughness 0.05 }
}
