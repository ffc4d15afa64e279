// Soft shadows: a round lamp over glasses, light that falls through a window, and a lantern that lights its own things only.
//   isl render scenes/features/area_lights.isl -s 1000x600
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }

camera { location <0.4, 3.2, -8.4> look_at <0.2, 0.75, 0> angle 50 right 5/3*x up y }

// The lamp: a disc of 17 x 17 points that faces what it lights, looked at closer where its shadows have edges.
light_source { <-3.6, 6.2, -3.4>, rgb <0.8, 0.62, 0.42> area_light 2*x, 2*y, 17, 17 circular orient adaptive 1 }
// The evening sky through a window with a cross.
light_source {
  <7.4, 4.6, 0.4>, rgb <0.7, 0.95, 1.5>
  area_light 0.12*z, 0.12*y, 5, 5 adaptive 1
  projected_through {
    union {
      #for (I, 0, 1)
        #for (J, 0, 1)
          box { 0, <0.05, 0.5, 0.5> translate <4.6, 1.9 + 0.68*I, -0.85 + 0.68*J> }
        #end
      #end
    }
  }
}

plane { y, 0 pigment { rgb <0.82, 0.78, 0.72> } finish { ambient 0.03 diffuse 0.75 } }
plane { -z, -5 pigment { rgb <0.7, 0.68, 0.66> } finish { ambient 0.03 diffuse 0.7 } }

#macro Glass(Where, Size, Colour)
  sphere {
    Size*y, Size
    pigment { rgbf <Colour.red, Colour.green, Colour.blue, 0.9> }
    finish { ambient 0 diffuse 0.05 specular 0.7 roughness 0.003 reflection { 0.02, 0.6 fresnel } }
    interior { ior 1.3 }
    translate Where
  }
#end
Glass(<-1.9, 0, 0.5>, 0.85, <0.95, 0.45, 0.25>)
Glass(<-0.3, 0, -1.1>, 0.5, <0.4, 0.85, 0.5>)
Glass(<-0.5, 0, 1.7>, 0.7, <0.4, 0.55, 0.95>)

// A picket of sticks shows how a shadow softens with the distance.
#for (I, 0, 6)
  cylinder { <0, 0, 0>, <0, 1.9, 0>, 0.035 pigment { rgb <0.75, 0.6, 0.42> } finish { ambient 0.03 diffuse 0.7 } translate <0.7 + 0.2*I, 0, 0.4 + 0.16*I> }
#end

// A bowl that is another colour inside.
difference {
  sphere { 0, 0.7 } sphere { 0, 0.64 } plane { -y, -0.15 }
  texture { pigment { rgb <0.85, 0.82, 0.78> } finish { ambient 0.03 diffuse 0.7 } }
  rotate <-12, 0, 8> translate <2.1, 0.68, -1.3>
}

// The lantern's light stays with the spheres in its group, whose upper sides are bright by their slope.
light_group {
  light_source { <2.1, 0.9, -1.3>, rgb <1.4, 0.9, 0.3> fade_distance 0.5 fade_power 2 }
  #for (I, 0, 5)
    sphere {
      <0.26, 0, 0>, 0.11
      pigment { slope { y, 0.3, 1 } color_map { [0 rgb <0.7, 0.2, 0.1>] [1 rgb <1, 0.85, 0.5>] } }
      finish { ambient 0.05 diffuse 0.8 specular 0.4 }
      rotate 60*I*y translate <2.1, 0.42, -1.3>
    }
  #end
  global_lights on
}
