// A lens: the middle of a string of beads is sharp, what is nearer and farther melts into light.
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  location <-1.8, 1.3, -4.4> look_at <0.1, 0.35, 0> angle 34
  focal_point <0, 0.4, 0> aperture 0.55 blur_samples 100
}
background { rgb <0.1, 0.12, 0.2> }
light_source { <-5, 8, -6> rgb 0.9 area_light 2*x, 2*z, 4, 4 jitter }
light_source { <6, 4, 3> rgb <0.4, 0.3, 0.2> shadowless }
plane { y, 0 pigment { rgb <0.35, 0.34, 0.4> } finish { diffuse 0.7 reflection 0.12 } }
#for (I, -6, 14)
  blob {
    kernel "cubic" hardness 2.5
    sphere { 0, 0.3 } sphere { 0.34*y, 0.16 } sphere { <0.2, 0.2, 0>, 0.12 } sphere { <-0.2, 0.2, 0>, 0.12 }
    pigment { rgb <0.9, 0.5 - 0.02 * I, 0.2 + 0.04 * I> } finish { specular 0.5 roughness 0.02 }
    rotate 40 * I * y
    translate <0.62 * I, 0.3, 0.85 * I>
  }
#end
#for (I, 0, 30)
  sphere { <-6 + 0.9 * I, 1.5 + 1.2 * sin(I * 2.3), 14 + 3 * cos(I * 1.7)>, 0.05 pigment { rgb 6 } finish { ambient 1 diffuse 0 } no_shadow }
#end
