// Lights: two spots that cross, a beam, a lamp whose light fades, and paper that is lit from behind.
//   isl render scenes/features/lights.isl -s 1000x500
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 3.4, -9> look_at <0.3, 0.9, 0> angle 56 right 2*x up y }

light_source { <-4, 6, -3>, rgb <1, 0.75, 0.45> spotlight point_at <-1.6, 0, 0.5> radius 12 falloff 20 tightness 4 }
light_source { <1.5, 6, -4>, rgb <0.45, 0.6, 1> spotlight point_at <-0.9, 0, 0.2> radius 10 falloff 22 }
light_source { <3.2, 6, 1>, rgb <0.7, 0.9, 0.6> cylinder point_at <3.2, 0, 0> radius 0.5 falloff 0.8 tightness 1 }
light_source {
  <0.9, 0.55, -0.9>, rgb <1.6, 1.2, 0.8> fade_distance 0.9 fade_power 2
  looks_like { sphere { 0, 0.12 pigment { rgb <1, 0.85, 0.6> } finish { ambient 0 diffuse 0 emission 1 } } }
}
light_source { <-3, 9, -8>, rgb 0.1 parallel point_at 0 shadowless }

plane { y, 0 pigment { rgb 0.8 } finish { ambient 0 diffuse 0.8 } }
plane { -z, -4 pigment { rgb <0.7, 0.72, 0.78> } finish { ambient 0 diffuse 0.7 } }

sphere { <-1.3, 0.7, 0.4>, 0.7 pigment { rgb <0.9, 0.88, 0.85> } finish { ambient 0 diffuse 0.7 specular 0.5 roughness 0.02 } }
cylinder { <3.2, 0, 0>, <3.2, 1, 0>, 0.35 pigment { rgb <0.8, 0.8, 0.85> } finish { ambient 0 diffuse 0.7 } }

// A screen of paper around the lamp: a second share of `diffuse` lets it glow from behind.
#for (I, 0, 4)
  #local Angle = 250 + 35 * I;
  polygon {
    5, <-0.33, 0>, <0.33, 0>, <0.33, 1.15>, <-0.33, 1.15>, <-0.33, 0>
    pigment { rgb <1, 0.93, 0.8> } finish { ambient 0 diffuse 0.4, 0.7 }
    translate <0, 0, -0.95> rotate Angle*y translate <0.9, 0, -0.9>
  }
#end
